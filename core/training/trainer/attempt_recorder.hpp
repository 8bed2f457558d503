// Writes a running attempt into a CSV record, into a recording, into both or into neither.
#pragma once

#include "core/base/function_ref.hpp"
#include "core/training/attempt/recording_writer.hpp"
#include "core/training/trainer/record.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace meltpool {

/// A failing CSV record ends with a fault; the recording reports its own faults.
class AttemptRecorder {
  public:
    /// Writes a row in `file` for each following step. Throws InputError if it cannot be written.
    void writeCsv(const std::filesystem::path& file, const AttemptHead& head, const RecordKind& kind);
    bool writesCsv() const { return csv_ != nullptr; }
    /// Passes each following step to `recording`, until end().
    void recordInto(std::shared_ptr<RecordingWriter> recording) { recording_ = std::move(recording); }
    bool writes() const { return csv_ || recording_; }

    /// Simulated time over real time, around the next steps.
    void setRealTime(double ratio) { realTime_ = ratio; }
    /// Simulated time over real time, of all steps so far.
    double realTime() const { return pace_.ratio(); }

    /// Adds a step; `steps`: so far, including this one. Its row waits for complete().
    void step(std::uint64_t steps, const TorchSample& torch, const ArcState& arc);
    /// Adds an event after step `steps`, or a value that changes from there on.
    void event(std::uint64_t steps, std::string_view name, std::string_view value);
    void change(std::uint64_t steps, std::string_view key, std::string_view value);
    /// Sets the metal's figures of the oldest waiting row.
    void complete(const MetalStatistics& figures);

    /// Ends the CSV record alone. Expects no waiting row.
    void endCsv(std::string_view reason, std::uint64_t stateHash);
    /// Ends both after `steps` steps and `seconds` of metal time. Expects no waiting row.
    void end(std::string_view reason, std::uint64_t stateHash, std::uint64_t steps, double seconds);

    /// Reason why the CSV record ended by itself, as a sentence; else empty.
    const std::string& fault() const { return fault_; }

    /// Starts a new attempt: the count of real time begins again.
    void reset() { pace_ = {}; }
    void transfer(gl::StateArchive& archive); ///< saves or restores the count of real time

  private:
    void guard(FunctionRef<void()> write);

    std::unique_ptr<Record> csv_;
    std::shared_ptr<RecordingWriter> recording_;
    std::string fault_;
    double realTime_ = 1;
    RealTimeCount pace_;
};

} // namespace meltpool
