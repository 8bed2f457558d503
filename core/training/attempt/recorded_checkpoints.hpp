// Reads the checkpoints of a recording, to reach a time without all the steps before it.
#pragma once

#include "core/training/attempt/checkpoint.hpp"
#include "core/training/attempt/recording.hpp"
#include "core/training/judging/technique.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace meltpool {

/// Each checkpoint is packed against the first; they are read from the file on request. A checkpoint in a file leaves
/// out the hand's steps: they are measured again from the recording's steps.
class RecordedCheckpoints {
  public:
    /// `technique`: technique of the attempt before its first step; empty for metal without a seam.
    RecordedCheckpoints(const Recording& recording, std::optional<Technique> technique);

    size_t count() const { return places_.size(); }
    /// Time (s) of the newest checkpoint not after `time`; empty if there is none.
    std::optional<double> timeBefore(double time) const;
    /// The newest checkpoint not after `time`, whole. Throws InputError if the file changed or a checkpoint is damaged.
    std::optional<Checkpoint> before(double time);
    /// The newest checkpoint not after this step. Throws as before().
    std::optional<Checkpoint> beforeStep(size_t step);

  private:
    struct Place {
        RecordingCheckpoint at;
        double time = 0; ///< s
    };

    size_t countUntil(double time) const;
    std::optional<Checkpoint> last(size_t count);

    std::filesystem::path file_;
    std::vector<Place> places_;
    std::optional<Technique> technique_;  ///< technique of the whole attempt
    std::optional<Checkpoint> reference_; ///< set at the first use
};

} // namespace meltpool
