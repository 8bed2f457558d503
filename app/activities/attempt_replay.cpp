#include "app/activities/attempt_replay.hpp"

#include "core/base/error.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

void AttemptReplay::begin(const Trainer& trainer, ReplayMachine machine, double (*now)()) {
    end();
    const Lesson& lesson = trainer.lesson();
    const double duration = lesson.torch.duration();
    attempt_ = lesson.recorded;
    machine_ = std::move(machine);
    now_ = now;
    if (attempt_) marks_ = timelineMarks(*attempt_, duration);
    speed_.begin(duration);
    distance_.begin(duration);
    moments_ = std::make_unique<CheckpointRing>(CheckpointRingLimits{kSpacing, kRoom});
    try {
        recorded_ = fileCheckpoints(lesson, machine_);
    } catch (const InputError& fault) { // the file has changed since the attempt was read
        recorded_.refused = fault.what();
    }
    const double start = attempt_ && attempt_->firstArc ? *attempt_->firstArc - kBeforeArc : 0;
    line_.begin(duration, start >= kLeastSkipped ? start : 0);
}

void AttemptReplay::end() {
    line_.end();
    attempt_.reset();
    marks_.clear();
    faultsFound_ = false;
    comparison_.reset();
    moments_.reset();
    recorded_ = {};
}

std::optional<int> AttemptReplay::due(ActivityFrame& frame) {
    frame.trainer->listen(line_.seeking() ? nullptr : &frame.soundSteps);
    if (frame.stopped || (!line_.seeking() && !line_.playing())) {
        frame.clock.restart();
        collect();
        return std::nullopt;
    }
    if (!line_.seeking())
        return frame.clock.due(frame.seconds * line_.speed(), frame.trainer->timeStep(), frame.beside);
    frame.changed |= seek(*frame.trainer, frame.seconds, frame.profiler);
    frame.clock.restart();
    finish(frame);
    return std::nullopt;
}

void AttemptReplay::step(ActivityFrame& frame, int, int) {
    step(*frame.trainer, frame.profiler);
}

void AttemptReplay::finish(ActivityFrame& frame) {
    if (findFaults(*frame.trainer)) frame.clock.restart();
    collect();
}

bool AttemptReplay::isOver(const Trainer& trainer) const {
    if (attempt_ && attempt_->rows > 0) return trainer.steps() >= attempt_->rows;
    return trainer.time() >= line_.duration() - 0.5 * trainer.timeStep();
}

void AttemptReplay::step(Trainer& trainer, gl::Profiler* profiler) {
    if (isOver(trainer)) return line_.reach(trainer.time(), trainer.timeStep(), true);
    trainer.advanceDemonstration(profiler);
    noteCurves(trainer);
    keepCheckpoint(trainer);
    const bool over = isOver(trainer);
    line_.reach(trainer.time(), trainer.timeStep(), over);
    if (over) compare(trainer);
}

bool AttemptReplay::seek(Trainer& trainer, double seconds, gl::Profiler* profiler) {
    if (line_.takeFresh()) {
        goBack(trainer);
        line_.stepFrom(trainer.time());
        line_.reach(trainer.time(), trainer.timeStep(), isOver(trainer));
        pace_.begin(seconds);
    } else {
        pace_.frame(seconds);
    }
    const double begin = now_();
    for (int made = 0; line_.seeking() && made < pace_.steps() && now_() - begin < pace_.slice(); ++made)
        step(trainer, profiler);
    return !line_.seeking();
}

/// Restores the checkpoint with the fewest steps to the target: the current metal, a checkpoint taken during playback,
/// or one of the recording.
void AttemptReplay::goBack(Trainer& trainer) {
    const double target = line_.target() + 0.5 * trainer.timeStep();
    const bool behind = trainer.time() > target;
    if (!behind && target - trainer.time() < kSpacing) return;
    const auto kept = moments_->before(target);
    const auto recorded = recorded_.moments ? recorded_.moments->timeBefore(target) : std::nullopt;
    const double here = behind ? -1 : trainer.time();
    const double mine = kept ? kept->time : -1, theirs = recorded ? *recorded : -1;
    const double newest = std::max({here, mine, theirs});
    if (newest == here && !behind) return;
    if (kept && mine == newest)
        trainer.restore(*kept);
    else if (recorded.has_value() && theirs == newest)
        restoreRecorded(trainer, target);
    else
        toStart(trainer);
    comparison_.reset();
}

void AttemptReplay::toStart(Trainer& trainer) {
    trainer.reset();
    trainer.show(trainer.lesson().torch.sample(0));
}

/// Restores a checkpoint of the recording. If one is damaged, or of another lesson after all, no more of them are used.
void AttemptReplay::restoreRecorded(Trainer& trainer, double target) {
    try {
        trainer.restore(*recorded_.moments->before(target));
    } catch (const InputError& fault) {
        recorded_ = {nullptr, phrase("attempt.moments.faulty", {{"fault", fault.what()}})};
        toStart(trainer);
    }
}

void AttemptReplay::noteCurves(const Trainer& trainer) {
    const Technique* technique = trainer.technique();
    if (technique == nullptr || technique->steps().empty() || !technique->steps().back().welds) return;
    constexpr double kMilli = 1e3;
    speed_.add(trainer.time(), technique->now()[TechniqueQuantity::travelSpeed] * kMilli);
    distance_.add(trainer.time(), technique->now()[TechniqueQuantity::distance] * kMilli);
}

/// Takes a checkpoint if due. Checkpoints stay when the attempt goes back, because it reaches the identical bits again.
/// While seeking, those of the recording serve if it has one just before.
void AttemptReplay::keepCheckpoint(const Trainer& trainer) {
    if (!moments_->due(trainer.time())) return;
    const auto recorded = recorded_.moments ? recorded_.moments->timeBefore(trainer.time()) : std::nullopt;
    if (line_.seeking() && recorded && trainer.time() - *recorded < 2 * kSpacing) return;
    const Technique* technique = trainer.technique();
    trainer.capture(moments_->capture(), moments_->historyTo());
    moments_->begun(trainer.time(), technique == nullptr ? 0 : technique->steps().size());
}

bool AttemptReplay::findFaults(const Trainer& trainer) {
    const Technique* technique = trainer.technique();
    if (faultsFound_ || !comparison_ || technique == nullptr) return false;
    faultsFound_ = true;
    const std::vector<TimelineMark> faults = faultMarks(*technique, trainer.judge());
    marks_.insert(marks_.end(), faults.begin(), faults.end());
    return true;
}

void AttemptReplay::collect() {
    moments_->update();
}

void AttemptReplay::compare(const Trainer& trainer) {
    comparison_ = replayEnd(attempt_ ? &*attempt_ : nullptr, trainer.steps(), trainer.result().stateHash, machine_);
}

} // namespace meltpool
