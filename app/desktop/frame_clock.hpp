// The program's clock as the window's frames read it, s since the window was opened.
#pragma once

#include <chrono>

namespace meltpool {

class FrameClock {
  public:
    double now() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }

    /// Begins a frame. Answers the time since the last one, or since restart(), s.
    double next() {
        const double last = frame_;
        frame_ = now();
        return frame_ - last;
    }
    /// The next frame's time counts from now on.
    void restart() { frame_ = now(); }
    /// When the frame under way began.
    double frame() const { return frame_; }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point begun_ = Clock::now();
    double frame_ = 0;
};

} // namespace meltpool
