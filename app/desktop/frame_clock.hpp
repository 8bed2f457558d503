// Reads the program's clock for the window's frames, s since the window opened.
#pragma once

#include <chrono>

namespace meltpool {

class FrameClock {
  public:
    double now() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }

    /// Begins a frame. Returns the time since the last one, or since restart(), s.
    double next() {
        const double last = frame_;
        frame_ = now();
        return frame_ - last;
    }
    /// Restarts the next frame's time from now.
    void restart() { frame_ = now(); }
    /// Begin of the current frame, s.
    double frame() const { return frame_; }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point begun_ = Clock::now();
    double frame_ = 0;
};

} // namespace meltpool
