// The lesson's demonstration for window and headset: the expert's torch, played, paused or moved to another time.
#pragma once

#include "app/activities/activity.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

/// Demonstration of a lesson. From its start the torch welds the metal. Moved to another time it moves alone, over the
/// metal in its start state: metal cannot jump to a time without all the steps before it.
class Demonstration final : public Activity {
  public:
    static constexpr double kKeyStep = 0.5; ///< s per stroke of an arrow key

    /// Starts. `duration` of the expert's path, s. `otherSettings`: the machine is set as the lesson has it, not as the
    /// person.
    void begin(double duration, bool otherSettings = false) {
        *this = {};
        duration_ = duration;
        otherSettings_ = otherSettings;
        playing_ = welds_ = true;
    }
    void end() { *this = {}; }

    Allowed allowed() const override { return {.values = true}; }
    NextAttempt nextAttempt(bool forScore) const override;
    std::optional<int> due(ActivityFrame& frame) override;
    void step(ActivityFrame& frame, int step, int steps) override;
    void finish(ActivityFrame& frame) override;

    bool playing() const { return playing_; }
    bool welds() const { return welds_; }
    double time() const { return time_; } ///< s
    double duration() const { return duration_; }

    /// Pauses or continues; at the end it starts again.
    void toggle() {
        if (time_ >= duration_) return again();
        playing_ = !playing_;
    }
    /// Moves the torch, without the metal, to a time.
    void moveTo(double time) {
        time_ = std::clamp(time, 0.0, duration_);
        metalDue_ = metalDue_ || welds_;
        welds_ = false;
    }
    /// Starts again, with the metal.
    void again() {
        time_ = 0;
        playing_ = welds_ = metalDue_ = true;
    }

    /// Returns true once after each change that needs the metal in its start state.
    bool takeMetalDue() { return std::exchange(metalDue_, false); }
    /// Sets the time that the torch has reached.
    void reach(double time) {
        time_ = std::min(time, duration_);
        if (time >= duration_) playing_ = false;
    }

  private:
    bool playing_ = false;
    bool welds_ = false;
    bool metalDue_ = false;
    bool otherSettings_ = false;
    double time_ = 0;
    double duration_ = 0;
};

} // namespace meltpool
