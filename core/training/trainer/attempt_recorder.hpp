// Writes an attempt while it runs: into a CSV record, into a recording, into both or into neither.
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

/// A CSV record that cannot be written on ends with a fault; the recording tells of its own faults itself.
class AttemptRecorder {
  public:
    /// Each following step has a row in `file`. Throws InputError when it cannot be written.
    void writeCsv(const std::filesystem::path& file, const AttemptHead& head, bool paced, bool replace);
    bool writesCsv() const { return csv_ != nullptr; }
    /// Each following step is brought to `recording`, until end().
    void recordInto(std::shared_ptr<RecordingWriter> recording) { recording_ = std::move(recording); }
    bool writes() const { return csv_ || recording_; }

    /// Simulated over real time about the next steps.
    void setRealTime(double ratio) { realTime_ = ratio; }
    /// The same over all steps so far.
    double realTime() const { return pace_.ratio(); }

    /// A step was made; `steps`: so far, with this one. Its row waits for complete().
    void step(std::uint64_t steps, const TorchSample& torch, const ArcState& arc);
    /// Something happened after step `steps`, or a value is another one from there on.
    void event(std::uint64_t steps, std::string_view name, std::string_view value);
    void change(std::uint64_t steps, std::string_view key, std::string_view value);
    /// The metal's figures of the oldest waiting row.
    void complete(const MetalStatistics& figures);

    /// Ends the CSV record alone. Expects no waiting row.
    void endCsv(std::string_view reason, std::uint64_t stateHash);
    /// Ends both after `steps` steps and `seconds` of the metal's time. Expects no waiting row.
    void end(std::string_view reason, std::uint64_t stateHash, std::uint64_t steps, double seconds);

    /// Why the CSV record ended before it was asked to, as a sentence; empty: it did not.
    const std::string& fault() const { return fault_; }

    /// A new attempt: the count of real time begins again.
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
