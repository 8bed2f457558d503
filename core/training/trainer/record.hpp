// Writes the record of an attempt: torch, metal and arc of every step, and the events between the steps, as a CSV that
// is a torch path again.
#pragma once

#include "core/metal/state/statistics.hpp"
#include "core/training/attempt/attempt_head.hpp"
#include "core/weld/process/arc.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool::gl {
class StateArchive;
}

namespace meltpool {

/// Data of a step before its figures arrive.
struct RecordStep {
    TorchSample torch;
    ArcState arc;
    double realTime = 1; ///< simulated time over real time, around this step
};

/// Counts the metal's time against the clock, over many steps.
class RealTimeCount {
  public:
    /// `ratio`: simulated time over real time, around this step.
    void add(double ratio);
    /// Simulated time over real time of all steps together; 1 before the first.
    double ratio() const { return realSteps_ > 0 ? static_cast<double>(steps_) / realSteps_ : 1; }
    double least() const { return least_; }
    void transfer(gl::StateArchive& archive); ///< saves or restores it

  private:
    size_t steps_ = 0;
    double realSteps_ = 0; ///< sum of the steps' real over simulated time
    double least_ = 1;
};

struct RecordKind {
    bool paced = false;   ///< a person welds by the clock, and the column `real_time` holds the metal's speed
    bool replace = false; ///< a file of this name may be replaced
    /// Ended record whose values and rows are the new one's first ones; empty: none.
    std::filesystem::path from = {};
};

/// A row is written when the figures of its own step have come from the GPU; until then it waits, in the order of the
/// steps. Each row reaches the operating system as soon as it is complete, so that a sudden end loses only the waiting
/// rows.
class Record {
  public:
    /// Rows that may wait for their figures.
    static constexpr size_t kWaiting = kStatisticsInFlight + 1;

    /// Creates the file, which must not exist unless it may be replaced. Throws InputError if it cannot be written, or
    /// if RecordKind::from cannot be read.
    Record(const std::filesystem::path& file, const AttemptHead& head, const RecordKind& kind);

    /// Notes an event after the last step: a line `# event NAME VALUE`.
    void event(std::string_view name, std::string_view value);
    /// Notes a value that changes from the next step on: a line `# set KEY VALUE`.
    void change(std::string_view key, std::string_view value);

    /// Adds a step; complete() brings its figures. Expects fewer than kWaiting waiting ones.
    void add(const RecordStep& step);
    size_t waiting() const { return waiting_; }
    /// Writes the oldest waiting step with its figures. Throws RuntimeFault if the disk takes no more.
    void complete(const MetalStatistics& metal);

    /// Ends the record: lines `# ended REASON`, the state's hash, and for a paced one its real-time ratio. Expects no
    /// waiting step. Throws RuntimeFault if the disk takes no more.
    void end(std::string_view reason, std::uint64_t stateHash);

    const std::filesystem::path& file() const { return file_; }
    size_t rows() const { return rows_; }

  private:
    void continueFrom(const std::filesystem::path& record, std::string& text);
    void write(std::string_view text);

    struct Waiting {
        RecordStep step;
        std::string before; ///< lines before its row
    };

    std::filesystem::path file_;
    std::ofstream stream_;
    bool arc_;
    bool rod_;
    bool paced_;
    std::array<Waiting, kWaiting> steps_;
    size_t oldest_ = 0;
    size_t waiting_ = 0;
    std::string before_; ///< lines for the next step
    std::string row_;    ///< reused buffer of a row
    size_t rows_ = 0;
    RealTimeCount pace_;
};

} // namespace meltpool
