#include "app/activities/demonstration.hpp"

namespace meltpool {

NextAttempt Demonstration::nextAttempt(bool forScore) const {
    return forScore || otherSettings_ ? NextAttempt::freshMetal : NextAttempt::sameMetal;
}

/// Welds the metal only if the demonstration asks for it; otherwise only the torch moves.
std::optional<int> Demonstration::due(ActivityFrame& frame) {
    if (takeMetalDue()) {
        frame.trainer->reset();
        frame.clock.restart();
        frame.stopped = false;
        frame.changed = true;
    }
    const bool plays = playing_ && !frame.stopped;
    if (!plays) frame.clock.restart();
    if (plays && welds_) return frame.clock.due(frame.seconds, frame.trainer->timeStep(), frame.beside);
    if (plays) reach(time_ + frame.seconds);
    if (!welds_) frame.trainer->show(frame.trainer->lesson().torch.sample(time_));
    return std::nullopt;
}

void Demonstration::step(ActivityFrame& frame, int, int) {
    frame.trainer->advanceDemonstration(frame.profiler);
}

void Demonstration::finish(ActivityFrame& frame) {
    reach(frame.trainer->time());
}

} // namespace meltpool
