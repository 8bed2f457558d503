#include "app/session/start_camera.hpp"

#include "core/training/lesson/lesson.hpp"
#include "core/training/trainer/classic_model.hpp"
#include "core/weld/workpiece/position.hpp"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <span>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr double kRunOn = 6e-3; ///< m of the seam before and behind the counted length
constexpr int kSeamPoints = 12;
constexpr float kTorchShown = 45e-3f; ///< m of the torch from its tip: enough to see how it leans
constexpr float kCube = 0.5f;         ///< half an edge of the classic cube, world units
constexpr float kBurner = 0.4f;       ///< height of the heat source's burner over its flame, world units

void addCube(std::vector<glm::vec3>& points) {
    for (const float x : {-kCube, kCube})
        for (const float y : {-kCube, kCube})
            for (const float z : {-kCube, kCube})
                points.push_back({x, y, z});
}

} // namespace

std::vector<glm::vec3> pointsToShow(const Lesson& lesson, const DeskTorch& torch) {
    std::vector<glm::vec3> points;
    if (!torch.leads()) {
        addCube(points);
        for (const float up : {0.0f, kBurner})
            points.push_back(SteeredSource::kHome + glm::vec3(0, up, 0));
        return points;
    }
    const glm::mat3 turn = fixtureOf(lesson.workpiece).turn;
    const auto add = [&](const glm::vec3& place) { points.push_back(turn * place / kClassicUnit); };
    const Seam seam = seamOf(lesson.workpiece);
    double from = seam.begin(), to = seam.end();
    if (lesson.technique) { // a weld begins before the counted length and runs on past it
        from = lesson.technique->lengthFromMm * kMm - kRunOn;
        to = lesson.technique->lengthToMm * kMm + kRunOn;
    }
    if (!seam.closed()) {
        from = std::max(from, seam.begin());
        to = std::min(to, seam.end());
    }
    for (int i = 0; i <= kSeamPoints; ++i)
        add(glm::vec3(seam.at(from + (to - from) * i / kSeamPoints).point));
    const TorchSample start = torch.sample();
    add(start.tip);
    add(start.tip - start.axis() * kTorchShown);
    return points;
}

void StartCamera::begin(Controls& controls, const Lesson& lesson, const DeskTorch& torch) {
    const CameraParameters& camera = lesson.camera;
    wanted_ = OrbitCamera(glm::radians(camera.azimuth), glm::radians(camera.elevation), camera.distance);
    placed_ = wanted_;
    points_ = pointsToShow(lesson, torch);
    controls.placeCamera(placed_);
}

void StartCamera::frame(Controls& controls, const CoveredEdges& covered, float aspect, bool torch) {
    if (controls.orbitCamera() != placed_) return;
    const std::span<const glm::vec3> points(points_);
    placed_ = framed(wanted_, controls.lens, aspect, covered,
                     torch ? points : points.first(points.size() - std::min(points.size(), kTorchPoints)));
    controls.placeCamera(placed_);
}

} // namespace meltpool
