// Which moments of an attempt its recording takes, so that it keeps to a few megabytes a minute.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

namespace meltpool {

class CheckpointPace {
  public:
    static constexpr double kPeriod = 2; ///< s of the metal's time between two that are taken, at least
    /// Bytes for each second that was welded, without the first moment, which stands alone: with the steps' own some
    /// 16 kB a second they make 5 MB a minute.
    static constexpr double kBytesPerSecond = 65e3;

    /// Whether the moment of this time (s) and size is taken. Moments come in the order in which they were welded;
    /// where the attempt went back, from there on again.
    bool take(double time, size_t bytes) {
        welded_ += std::max(0.0, time - seen_);
        if (time < seen_) last_ = time - kPeriod;
        seen_ = time;
        const bool first = last_ == -std::numeric_limits<double>::infinity();
        if (!first && time < last_ + kPeriod - kSlack) return false;
        const double sum = first ? 0 : taken_ + static_cast<double>(bytes);
        if (sum > kBytesPerSecond * welded_) return false;
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
