// The conversion of the frames' real time into whole simulation steps, so that the metal's time is the hand's time.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

/// Clock of the steps. Steps have a fixed length at any frame rate, and follow the clock as long as the machine can: a
/// frame makes the steps for its time, up to kBusy of work. Time beyond that is dropped, so that a slow machine
/// simulates more slowly instead of making ever longer frames; see speed().
class StepClock {
  public:
    static constexpr double kBusy = 0.08;      ///< s that a frame may spend on steps
    static constexpr double kBeside = 0.045;   ///< s of steps in parallel with a picture, or its time if longer
    static constexpr double kLongest = 0.25;   ///< s of real time that a frame may catch up on
    static constexpr double kLongestGap = 0.1; ///< s of the metal's time between two samples of the hand at most
    static constexpr int kFewest = 1;          ///< least count of steps in a frame, however slow they are

    /// Returns the steps due after another `elapsed` seconds of real time with steps of `step` seconds. The first call
    /// after a restart only starts the clock. `beside`: s that a frame takes apart from steps, which run in parallel;
    /// then late steps fill that time or kBeside, so that pictures follow each other quickly and the steps' thread does
    /// not idle. 0: the frame waits for its steps.
    int due(double elapsed, double step, double beside = 0) {
        dropped_ = false;
        busy_ = 0;
        if (!started_) {
            started_ = true;
            return 0;
        }
        owed_ += std::max(0.0, elapsed);
        const int steps = std::min(mostSteps(step, beside), static_cast<int>(owed_ / step + 1e-9));
        owed_ = std::min(owed_ - steps * step, step);
        dropped_ = elapsed > kLongest && steps * step > kLongestGap;
        smooth(elapsed, steps * step);
        return steps;
    }

    /// True if the last frame took longer than the clock can catch up on, and much of the metal's time passed in it:
    /// the hand's motion in that time is unknown. Metal far slower than the clock passes little time in any frame.
    bool dropped() const { return dropped_; }

    /// Takes the time that `steps` steps kept the frame waiting, s.
    void took(double seconds, int steps) {
        if (steps <= 0) return;
        busy_ = seconds;
        const double each = seconds / steps;
        cost_ += (each - cost_) * (cost_ <= 0 ? 1.0 : each > cost_ ? kDearer : kCheaper);
    }

    /// Time that the newest frame waited for its steps, s.
    double busy() const { return busy_; }
    /// Part of busy() for steps in parallel with a picture no longer than kBeside, s.
    double busyBeside() const { return cost_ > 0 ? std::min(busy_, std::ceil(kBeside / cost_) * cost_) : busy_; }

    /// Drops the time that has not been simulated yet, after a pause.
    void restart() {
        owed_ = 0;
        busy_ = 0;
        started_ = false;
    }
    /// Clears everything, also the measurements.
    void reset() { *this = {}; }

    /// Simulated over real time, smoothed over about a second; 1 when the machine keeps up.
    double speed() const { return real_ > 0 ? simulated_ / real_ : 1; }

    /// Simulated over real time while only steps of `step` seconds are made; infinite before a measurement. On a card
    /// it counts the processor's part of a step.
    double speedOfSteps(double step) const {
        return cost_ > 0 ? step / cost_ : std::numeric_limits<double>::infinity();
    }

  private:
    /// Shares by which a new cost replaces the old. A struck arc makes steps several times as costly: with a small
    /// share the next frames would be so long that the hand's motion in them is unknown.
    static constexpr double kDearer = 0.6;
    static constexpr double kCheaper = 0.2;

    int mostSteps(double step, double beside) const {
        const double most = kLongest / step;
        if (cost_ <= 0) return std::max(kFewest, static_cast<int>(most));
        const double bearable = beside > 0 ? std::ceil(besideTime(beside) / cost_) : kBusy / cost_;
        return std::max(kFewest, static_cast<int>(std::min(bearable, most)));
    }
    static double besideTime(double beside) { return std::clamp(beside, kBeside, kBusy); }

    void smooth(double real, double simulated) {
        const double keep = 1 / (1 + std::max(0.0, real));
        real_ = real_ * keep + real;
        simulated_ = simulated_ * keep + simulated;
    }

    double owed_ = 0;
    double real_ = 0;
    double simulated_ = 0;
    double cost_ = 0; ///< s per step
    double busy_ = 0; ///< s of the newest frame's steps
    bool started_ = false;
    bool dropped_ = false;
};

} // namespace meltpool
