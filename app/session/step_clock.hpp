// Turns the real time of frames into whole simulation steps.
#pragma once

#include <algorithm>

namespace meltpool {

/// Steps have a fixed length whatever the frame rate. A frame runs at most two; further time is dropped, so that a slow
/// machine simulates more slowly instead of taking ever longer frames.
class StepClock {
  public:
    static constexpr int kMostSteps = 2;

    /// Steps due after another `elapsed` seconds of real time with steps of `step` seconds.
    int due(double elapsed, double step) {
        owed_ += std::max(0.0, elapsed);
        const int steps = std::min(kMostSteps, static_cast<int>(owed_ / step + 1e-9));
        owed_ = std::min(owed_ - steps * step, step);
        smooth(elapsed, steps * step);
        return steps;
    }

    /// Drops the time that has not been simulated yet, after a pause.
    void restart() { owed_ = 0; }

    /// Simulated over real time, smoothed over about a second; 1 when the machine keeps up.
    double speed() const { return real_ > 0 ? simulated_ / real_ : 1; }

  private:
    void smooth(double real, double simulated) {
        const double keep = 1 / (1 + std::max(0.0, real));
        real_ = real_ * keep + real;
        simulated_ = simulated_ * keep + simulated;
    }

    double owed_ = 0;
    double real_ = 0;
    double simulated_ = 0;
};

} // namespace meltpool
