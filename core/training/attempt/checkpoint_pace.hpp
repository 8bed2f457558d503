// Which moments of an attempt its recording takes, so that a replay is at any second soon and the disk lasts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

namespace meltpool {

class CheckpointPace {
  public:
    /// s of the metal's time between two moments, at most and at least.
    static constexpr double kPeriod = 1, kLeastPeriod = 0.4;

    /// s from one moment to the next where making steps alone runs at `speed` times the clock: as far as this machine
    /// welds in a second, so that from a moment it comes to any time before the next one in about as long.
    static double period(double speed) { return std::clamp(speed, kLeastPeriod, kPeriod); }

    /// Bytes for each second that was welded, without the first moment, which stands alone. Moments of 30,000 particles
    /// have some 300 kB at first, 550 kB on a plate that ten beads have made hot all over; with the steps' own 16 kB a
    /// second this makes 60 MB a minute at most.
    static constexpr double kBytesPerSecond = 970e3;
    static constexpr double kAtOnce = 1e6; ///< bytes ahead of that, for the first seconds

    /// Whether the moment of this time (s) and size is taken. Moments come in the order in which they were welded;
    /// where the attempt went back, from there on again.
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
    static constexpr double kSlack = 0.1; ///< s: moments lie some steps farther apart than they are asked for

    double seen_ = 0, welded_ = 0, taken_ = 0;
    double last_ = -std::numeric_limits<double>::infinity();
};

} // namespace meltpool
