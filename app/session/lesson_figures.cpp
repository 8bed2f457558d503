#include "app/session/lesson_figures.hpp"

#include "app/session/lesson_session.hpp"

#include <cmath>

namespace meltpool {

void fillFigures(LessonFigures& figures, LessonSession& session) {
    const LessonRun& run = session.run();
    const Trainer* trainer = run.trainer();
    if (trainer == nullptr) return;
    const MetalStatistics& metal = trainer->figures();
    figures.time = trainer->time();
    figures.speed = run.clock().speed();
    figures.particles = metal.particles;
    figures.molten = metal.molten;
    figures.hottest = metal.maxTemperature;
    figures.kelvin = session.lesson().model == LessonModel::Weld;
    figures.lost = metal.lost;
    figures.refused = metal.nonFinite;
    figures.stopped = !run.fault().empty();
    figures.caption = session.sound().caption();
    const DeskTorch& torch = session.deskTorch();
    const bool led = session.leader() == TorchLeader::desk && torch.leads();
    figures.torch = led ? std::optional(torch.pose()) : std::nullopt;
    figures.distance = torch.distanceKind();
    // The judged distance, which cues and result have too; without metal below the torch that of the hand.
    if (led && trainer->technique() != nullptr)
        if (const double judged = trainer->technique()->now()[TechniqueQuantity::distance]; std::isfinite(judged))
            figures.torch->distance = judged;
}

} // namespace meltpool
