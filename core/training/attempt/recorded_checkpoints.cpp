#include "core/training/attempt/recorded_checkpoints.hpp"

#include "core/base/error.hpp"
#include "core/gl/state_archive.hpp"
#include "core/training/attempt/packing.hpp"
#include "core/training/attempt/recording_reader.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

namespace {

void measure(Technique& technique, const Recording& recording) {
    size_t next = 0;
    bool tracked = true;
    for (size_t made = 0; made < recording.steps.size(); ++made) {
        for (; next < recording.events.size() && recording.events[next].steps <= made; ++next) {
            const RecordingNote& event = recording.events[next];
            if (event.name == "torch") tracked = event.value != "lost";
            if (event.name == "samples") technique.noteDropped(droppedSeconds(event.value));
        }
        technique.add(recording.steps[made].torch, recording.steps[made].arc, tracked);
    }
}

} // namespace

RecordedCheckpoints::RecordedCheckpoints(const Recording& recording, std::optional<Technique> technique)
    : file_(recording.file), technique_(std::move(technique)) {
    for (const RecordingCheckpoint& each : recording.checkpoints)
        places_.push_back({each, each.steps == 0 ? 0 : recording.steps[each.steps - 1].torch.time});
    if (technique_ && !places_.empty()) measure(*technique_, recording);
}

size_t RecordedCheckpoints::countUntil(double time) const {
    const auto after =
        std::partition_point(places_.begin(), places_.end(), [&](const Place& place) { return place.time <= time; });
    return static_cast<size_t>(after - places_.begin());
}

std::optional<double> RecordedCheckpoints::timeBefore(double time) const {
    const size_t count = countUntil(time);
    return count == 0 ? std::nullopt : std::optional(places_[count - 1].time);
}

std::optional<Checkpoint> RecordedCheckpoints::before(double time) {
    return last(countUntil(time));
}

std::optional<Checkpoint> RecordedCheckpoints::beforeStep(size_t step) {
    const auto after = std::partition_point(places_.begin(), places_.end(),
                                            [&](const Place& place) { return place.at.steps <= step; });
    return last(static_cast<size_t>(after - places_.begin()));
}

/// The last checkpoint of the first `count`.
std::optional<Checkpoint> RecordedCheckpoints::last(size_t count) {
    if (count == 0) return std::nullopt;
    if (!reference_) reference_ = unpack(readCheckpoint(file_, places_.front().at));
    const RecordingCheckpoint& at = places_[count - 1].at;
    Checkpoint made = count == 1 ? *reference_ : unpack(readCheckpoint(file_, at), *reference_);
    const size_t known = technique_ ? technique_->steps().size() : 0;
    if (made.step != at.steps || made.historyTo > known)
        throw InputError(file_, 0,
                         "holds a checkpoint of step " + std::to_string(made.step) + " at step " +
                             std::to_string(at.steps) + "; expected one of this step");
    gl::StateArchive history(made.history);
    if (technique_) technique_->transferSteps(history, 0, made.historyTo);
    made.historyFrom = 0;
    made.historyTime = 0;
    seal(made);
    return made;
}

} // namespace meltpool
