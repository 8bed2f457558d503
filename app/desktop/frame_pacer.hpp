// Counts the window's frames and limits their rate.
#pragma once

#include <chrono>

namespace meltpool {

class FramePacer {
  public:
    using Clock = std::chrono::steady_clock;

    /// A frame of `seconds` of real time is over.
    void count(double seconds);
    /// Sleeps until the shortest time of a frame that began at `begin` is over.
    void pace(Clock::time_point begin) const;

    long long frames() const { return frames_; }
    /// Time of a frame, averaged over about half a second so that the figure can be read, s.
    double frameSeconds() const { return frameSeconds_; }
    double framesPerSecond() const { return frameSeconds_ > 0 ? 1 / frameSeconds_ : 0; }

  private:
    long long frames_ = 0;
    double frameSeconds_ = 0;
};

} // namespace meltpool
