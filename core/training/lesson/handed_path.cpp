#include "core/training/lesson/handed_path.hpp"

#include "core/training/judging/seam.hpp"
#include "core/weld/workpiece/position.hpp"

#include <cmath>

namespace meltpool {

namespace {

constexpr double kUpright = 5; // degrees
constexpr float kLevel = 0.5F; // sine of the steepest seam that is welded to either side

/// Returns the path's own direction along x: +1, -1, or 0 for a path that never welds.
int directionOf(const TorchPath& path) {
    const std::optional<double> begin = path.firstPull();
    if (!begin) return 0;
    double end = *begin;
    for (double time = *begin; time < path.duration(); time += TorchPath::kTriggerGrain)
        if (path.sample(time).trigger > 0) end = time;
    const float way = path.sample(end).tip.x - path.sample(*begin).tip.x;
    return way == 0 ? 0 : (way > 0 ? 1 : -1);
}

} // namespace

int directionForHand(const Lesson& lesson, WeldingHand hand) {
    if (lesson.model != LessonModel::Weld || !lesson.technique) return 0;
    const Seam seam = seamOf(lesson.workpiece);
    if (lesson.technique->direction != TravelDirection::either || seam.closed()) return 0;
    const glm::vec3 way = fixtureOf(lesson.workpiece).turn * glm::vec3(seam.at(0).tangent);
    if (std::abs(way.y) > kLevel) return 0;
    const TechniqueBand* travel = lesson.technique->find(TechniqueQuantity::travelAngle);
    if (travel == nullptr || std::abs(travel->ideal) < kUpright) return 0;
    const bool pushes = travel->ideal > 0;
    return (hand == WeldingHand::right) == pushes ? -1 : 1;
}

TorchPath pathForHand(const Lesson& lesson, WeldingHand hand) {
    const int wanted = directionForHand(lesson, hand), own = directionOf(lesson.torch);
    if (wanted == 0 || own == 0 || wanted == own) return lesson.torch;
    const Seam seam = seamOf(lesson.workpiece);
    return lesson.torch.mirrored((seam.begin() + seam.end()) / 2);
}

} // namespace meltpool
