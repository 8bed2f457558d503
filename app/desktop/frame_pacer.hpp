// Counts the window's frames and limits their rate.
#pragma once

#include <chrono>

namespace meltpool {

class FramePacer {
  public:
    using Clock = std::chrono::steady_clock;

    /// Counts a finished frame of `seconds` of real time.
    void count(double seconds);
    /// Sleeps until the shortest time of a frame that began at `begin` has passed.
    void pace(Clock::time_point begin) const;

    long long frames() const { return frames_; }
    /// Time of a frame, averaged over about half a second to be readable, s.
    double frameSeconds() const { return frameSeconds_; }
    double framesPerSecond() const { return frameSeconds_ > 0 ? 1 / frameSeconds_ : 0; }

  private:
    long long frames_ = 0;
    double frameSeconds_ = 0;
};

} // namespace meltpool
