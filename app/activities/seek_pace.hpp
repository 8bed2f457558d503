// How many steps a frame makes on the way to another moment, so that the window goes on answering.
#pragma once

#include <algorithm>

namespace meltpool {

/// Steps are held against their own time, whatever a picture costs beside them. Where the driver carries its orders out
/// at once, that is how long ordering them took; a card takes orders long before it has carried them out, so there it
/// is what a frame takes longer than one did without them.
class SeekPace {
  public:
    static constexpr double kLongestPicture = 0.5; ///< s; a longer frame without steps was held up by something else
    static constexpr int kFirst = 8;               ///< steps
    static constexpr int kMost = 4096;             ///< steps

    /// `slice`: s of a frame that steps may take.
    explicit SeekPace(double slice) : slice_(slice) {}

    double slice() const { return slice_; }
    int steps() const { return steps_; }
    /// The last frame, without steps, took `seconds`.
    void begin(double seconds) {
        picture_ = std::clamp(seconds, 0.0, kLongestPicture);
        steps_ = kFirst;
    }
    /// The last frame took `seconds`, with steps.
    void frame(double seconds) {
        const bool tooLong = seconds - picture_ > 1.5 * slice_;
        steps_ = tooLong ? std::max(1, steps_ / 2) : std::min(kMost, steps_ * 2);
    }

  private:
    double slice_;
    double picture_ = 0;
    int steps_ = kFirst;
};

} // namespace meltpool
