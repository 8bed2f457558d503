// The record of an attempt: torch, metal and arc of every step, and what happened between the steps, as a CSV that is a
// torch path again.
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

/// What is known of a step when it has been asked for.
struct RecordStep {
    TorchSample torch;
    ArcState arc;
    double realTime = 1; ///< simulated over real time about this step
};

/// How the metal's time goes against the clock, over many steps.
class RealTimeCount {
  public:
    /// `ratio`: simulated over real time about this step.
    void add(double ratio);
    /// Simulated over real time of all steps together; 1 before the first.
    double ratio() const { return realSteps_ > 0 ? static_cast<double>(steps_) / realSteps_ : 1; }
    double least() const { return least_; }
    void transfer(gl::StateArchive& archive); ///< saves or restores it

  private:
    size_t steps_ = 0;
    double realSteps_ = 0; ///< sum of the steps' real over simulated time
    double least_ = 1;
};

/// A row is written when the figures of its own step have come from the GPU; until then it waits, in the order of the
/// steps. Each row reaches the operating system as soon as it is complete, so that an end without warning loses the
/// waiting rows and no more.
class Record {
  public:
    /// Rows that may wait for their figures.
    static constexpr size_t kWaiting = kStatisticsInFlight + 1;

    /// Begins the file, which may not be there yet unless `replace`; `paced`: a person welds by the clock, and the
    /// column `real_time` says how well the metal kept up. Throws InputError when it cannot be written.
    Record(const std::filesystem::path& file, const AttemptHead& head, bool paced, bool replace);

    /// Notes something that happened after the last step: a line `# event NAME VALUE`.
    void event(std::string_view name, std::string_view value);
    /// A value that is another one from the next step on: a line `# set KEY VALUE`.
    void change(std::string_view key, std::string_view value);

    /// Adds a step, whose figures come with complete(). Expects fewer than kWaiting waiting ones.
    void add(const RecordStep& step);
    size_t waiting() const { return waiting_; }
    /// Writes the oldest waiting step with its figures. Throws RuntimeFault when the disk takes no more.
    void complete(const MetalStatistics& metal);

    /// Ends the record: lines `# ended REASON`, the state's hash, and for a paced one its real-time ratio. Expects no
    /// waiting step. Throws RuntimeFault when the disk takes no more.
    void end(std::string_view reason, std::uint64_t stateHash);

    const std::filesystem::path& file() const { return file_; }
    size_t rows() const { return rows_; }

  private:
    void line(std::string_view word, std::string_view name, std::string_view value);
    void write(std::string_view text);

    struct Waiting {
        RecordStep step;
        std::string before; ///< lines that stand before its row
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
    std::string row_;    ///< keeps its room from row to row
    size_t rows_ = 0;
    RealTimeCount pace_;
};

} // namespace meltpool
