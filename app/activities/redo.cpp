#include "app/activities/redo.hpp"

#include "core/training/attempt/checkpoint_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

constexpr double kAtPlace = 0.5e-3; // m, the nearness at which the arc counts as at a place

/// Way from b to a; on a circle a place recurs after each turn.
double away(const Seam& seam, double a, double b) {
    const double way = a - b;
    return std::abs(seam.closed() ? way - std::round(way / seam.length()) * seam.length() : way);
}

CheckpointTaker takerFor(std::shared_ptr<RecordingWriter> recording) {
    if (!recording) return {};
    return [recording = std::move(recording), pace = CheckpointSchedule()](const PackedCheckpoint& moment) mutable {
        if (pace.take(moment.time, moment.bytes.size()))
            recording->checkpoint(moment.step, {moment.bytes.begin(), moment.bytes.end()});
    };
}

} // namespace

std::optional<double> firstTimeAt(const Technique& technique, double place) {
    for (const TechniqueStep& step : technique.steps())
        if (step.welds && away(technique.seam(), step.place, place) <= kAtPlace) return step.time;
    return std::nullopt;
}

void Redo::begin(std::shared_ptr<RecordingWriter> recording, bool goes) {
    checkpoints_.clear(takerFor(std::move(recording)), goes);
    goes_ = goes;
    place_.reset();
    first_.reset();
    redone_ = 0;
}

void Redo::update(const Trainer& trainer, double speed) {
    checkpoints_.update();
    if (trainer.steps() == 0 || !checkpoints_.due(trainer.time(), CheckpointSchedule::period(speed))) return;
    const Technique* technique = trainer.technique();
    trainer.capture(checkpoints_.capture(), checkpoints_.historyTo());
    checkpoints_.begun(trainer.time(), technique == nullptr ? 0 : technique->steps().size());
    if (!first_) first_ = trainer.time();
}

std::optional<Checkpoint> Redo::target(const Trainer& trainer) {
    const auto place = std::exchange(place_, std::nullopt);
    if (!can()) return std::nullopt;
    const auto fault = place ? firstTimeAt(*trainer.technique(), *place) : std::nullopt;
    const double wanted = fault ? *fault - kRunUp : trainer.time() - kBack;
    auto moment = checkpoints_.before(std::max(wanted, *first_)); // not before the first checkpoint
    if (moment && moment->step >= trainer.steps()) moment.reset();
    return moment;
}

void Redo::recordInto(std::shared_ptr<RecordingWriter> recording) {
    checkpoints_.giveTo(takerFor(std::move(recording)));
}

void Redo::back(Trainer& trainer, const Checkpoint& moment) {
    trainer.redo(moment);
    checkpoints_.branch(moment.step);
    ++redone_;
}

} // namespace meltpool
