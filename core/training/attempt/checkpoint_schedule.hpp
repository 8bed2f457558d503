// Chooses which checkpoints of an attempt its recording takes, so that a replay reaches any second quickly and the disk
// does not fill up.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

namespace meltpool {

class CheckpointSchedule {
  public:
    /// Metal time between two checkpoints, s: at most and at least.
    static constexpr double kPeriod = 1, kLeastPeriod = 0.4;

    /// Seconds from one checkpoint to the next on a machine that makes steps at `speed` times real time. The machine
    /// welds this period in one second, so it reaches any time from the checkpoint before in about one second.
    static double period(double speed) { return std::clamp(speed, kLeastPeriod, kPeriod); }

    /// Bytes for each welded second, without the first checkpoint. Checkpoints of 30,000 particles have some 300 kB at
    /// first, and 550 kB on a plate that ten beads have heated all over; with the steps' own 16 kB a second this makes
    /// 60 MB a minute at most.
    static constexpr double kBytesPerSecond = 970e3;
    static constexpr double kAtOnce = 1e6; ///< extra bytes allowed at the start, for the first seconds

    /// True if the recording takes the checkpoint of this time (s) and size. Checkpoints come in the order of welding;
    /// after going back, from that time on again.
    bool take(double time, size_t bytes) {
        welded_ += std::max(0.0, time - seen_);
        if (time < seen_) last_ = time - kLeastPeriod;
        seen_ = time;
        const bool first = last_ == -std::numeric_limits<double>::infinity();
        if (!first && time < last_ + kLeastPeriod - kSlack) return false;
        const double sum = first ? 0 : taken_ + static_cast<double>(bytes);
        if (sum > kAtOnce + kBytesPerSecond * welded_) return false;
        taken_ = sum;
        last_ = time;
        return true;
    }

  private:
    static constexpr double kSlack = 0.1; ///< s: checkpoints come some steps farther apart than requested

    double seen_ = 0, welded_ = 0, taken_ = 0;
    double last_ = -std::numeric_limits<double>::infinity();
};

} // namespace meltpool
