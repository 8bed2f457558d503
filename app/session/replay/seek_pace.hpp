// How many steps a frame makes on the way to another moment, so that the window goes on answering.
#pragma once

#include <algorithm>

namespace meltpool {

/// A driver takes orders long before it has carried them out, so the time that steps take to order says little; what
/// counts is how long the whole last frame took.
class SeekPace {
  public:
    static constexpr double kSlice = 0.1;   ///< s of a frame that may go into ordering steps
    static constexpr double kLongest = 0.2; ///< s; a longer frame was too long
    static constexpr int kMost = 4096;      ///< steps

    void begin() { steps_ = 1; }
    /// The last frame took `seconds`.
    void frame(double seconds) { steps_ = seconds > kLongest ? std::max(1, steps_ / 2) : std::min(kMost, steps_ * 2); }
    int steps() const { return steps_; }

  private:
    int steps_ = 1;
};

} // namespace meltpool
