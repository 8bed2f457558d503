// The count of steps a frame makes while seeking, so that the window still responds.
#pragma once

#include <algorithm>

namespace meltpool {

/// Pace of a seek: the count of steps follows their own time, apart from the picture's. If the driver runs commands
/// synchronously, that is the time of issuing them; a card queues commands long before it finishes them, so there it is
/// the frame's time beyond one without steps.
class SeekPace {
  public:
    static constexpr double kLongestPicture = 0.5; ///< s; a longer frame without steps was held up by something else
    static constexpr int kFirst = 8;               ///< steps
    static constexpr int kMost = 4096;             ///< steps

    /// Sets the slice: s of a frame that steps may take.
    explicit SeekPace(double slice) : slice_(slice) {}

    double slice() const { return slice_; }
    int steps() const { return steps_; }
    /// Starts from a frame without steps that took `seconds`.
    void begin(double seconds) {
        picture_ = std::clamp(seconds, 0.0, kLongestPicture);
        steps_ = kFirst;
    }
    /// Takes the time of the last frame, with steps.
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
