#include "core/training/trainer/attempt_recorder.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/gl/state_archive.hpp"

#include <utility>

namespace meltpool {

void AttemptRecorder::writeCsv(const std::filesystem::path& file, const AttemptHead& head, const RecordKind& kind) {
    csv_ = nullptr;
    fault_.clear();
    csv_ = std::make_unique<Record>(file, head, kind);
}

void AttemptRecorder::step(std::uint64_t steps, const TorchSample& torch, const ArcState& arc) {
    pace_.add(realTime_);
    if (csv_) csv_->add({torch, arc, realTime_});
    if (recording_) recording_->step({steps, torch, arc, realTime_});
}

void AttemptRecorder::event(std::uint64_t steps, std::string_view name, std::string_view value) {
    if (csv_) csv_->event(name, value);
    if (recording_) recording_->event(steps, name, value);
}

void AttemptRecorder::change(std::uint64_t steps, std::string_view key, std::string_view value) {
    if (csv_) csv_->change(key, value);
    if (recording_) recording_->change(steps, key, value);
}

void AttemptRecorder::complete(const MetalStatistics& figures) {
    if (csv_ && csv_->waiting() > 0) guard([&] { csv_->complete(figures); });
}

void AttemptRecorder::endCsv(std::string_view reason, std::uint64_t stateHash) {
    if (csv_) guard([&] { csv_->end(reason, stateHash); });
    csv_ = nullptr;
}

void AttemptRecorder::end(std::string_view reason, std::uint64_t stateHash, std::uint64_t steps, double seconds) {
    if (recording_) { // first: a full disk under the record does not cost the recording its end
        RecordingEnd end;
        end.reason = reason;
        end.stateHash = formatHexadecimal(stateHash);
        end.steps = steps;
        end.seconds = seconds;
        end.realTime = pace_.ratio();
        end.leastRealTime = pace_.least();
        std::exchange(recording_, nullptr)->end(std::move(end));
    }
    endCsv(reason, stateHash);
}

/// The weld goes on after a failure; fault() has the reason.
void AttemptRecorder::guard(FunctionRef<void()> write) {
    try {
        write();
    } catch (const RuntimeFault& fault) {
        fault_ = fault.what();
        csv_ = nullptr;
    }
}

void AttemptRecorder::transfer(gl::StateArchive& archive) {
    archive.values(realTime_);
    pace_.transfer(archive);
}

} // namespace meltpool
