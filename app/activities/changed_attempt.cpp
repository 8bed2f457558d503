#include "app/activities/changed_attempt.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

/// Mean travel speed over the judged millimetres, m/s; nothing if none is known.
std::optional<double> meanTravelSpeed(const Judgement& judgement) {
    double sum = 0;
    int count = 0;
    for (const SeamMillimetre& mm : judgement.seam) {
        const double speed = mm.values[TechniqueQuantity::travelSpeed];
        if (!mm.judged || !std::isfinite(speed)) continue;
        sum += speed;
        ++count;
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

} // namespace

ChangedAttempt::ChangedAttempt(const Lesson& lesson, const std::string& wish, std::string words)
    : whatIf_(readWhatIf(std::array{wish}, lesson)), words_(std::move(words)) {
    if (lesson.recorded) steps_.reserve(lesson.recorded->rows);
}

void ChangedAttempt::stepOriginal(Trainer& trainer) {
    trainer.applyRecordedChanges();
    const TorchSample torch = trainer.demonstration();
    steps_.push_back({torch, static_cast<double>(trainer.metal().model().burntOff()), trainer.arc().burns()});
    trainer.advance(torch, nullptr);
}

void ChangedAttempt::change(Lesson& lesson, const Judgement& original) {
    whatIf_.path = whatIf_.path.resolved(meanTravelSpeed(original));
    takeWhatIf(lesson, whatIf_, whatIf_.path.speed);
    path_.emplace(std::move(steps_), seamOf(lesson.workpiece), whatIf_.path);
}

void ChangedAttempt::stepChanged(Trainer& trainer) const {
    trainer.applyRecordedChanges();
    trainer.advance(
        path_->sample(trainer.time() + trainer.timeStep(), static_cast<double>(trainer.metal().model().burntOff())),
        nullptr);
}

} // namespace meltpool
