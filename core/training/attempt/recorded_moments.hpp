// The moments of an attempt that its recording holds, to go to without all the steps before.
#pragma once

#include "core/training/attempt/checkpoint.hpp"
#include "core/training/attempt/recording.hpp"
#include "core/training/judging/technique.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace meltpool {

/// Each is packed against the first; they are read from the file when they are asked for. The hand's steps, which a
/// checkpoint in a file leaves out, are measured again from the recording's own.
class RecordedMoments {
  public:
    /// `technique`: that of the attempt before its first step; nothing for metal without a seam.
    RecordedMoments(const Recording& recording, std::optional<Technique> technique);

    size_t count() const { return places_.size(); }
    /// Time (s) of the newest that is not after `time`; nothing where there is none.
    std::optional<double> timeBefore(double time) const;
    /// That one, whole. Throws InputError where the file is another than before or a checkpoint is not sound.
    std::optional<Checkpoint> before(double time);
    /// The newest that is not after this step. Throws as before().
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
    std::optional<Technique> technique_;  ///< of the whole attempt
    std::optional<Checkpoint> reference_; ///< from the first use on
};

} // namespace meltpool
