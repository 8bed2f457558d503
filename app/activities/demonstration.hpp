// The lesson's demonstration as window and headset show it: the expert's torch, played, paused, brought to another
// time.
#pragma once

#include "app/activities/activity.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

/// From its start the torch welds the metal. Brought to another time it moves alone, over the metal as it was at first:
/// metal cannot be brought to a time without all the steps before it.
class Demonstration final : public Activity {
  public:
    static constexpr double kKeyStep = 0.5; ///< s, of a stroke of an arrow key

    /// `duration` of the expert's path, s. `otherSettings`: the machine is set as the lesson has it, not as the person.
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

    /// Pauses, or goes on; at the end it begins again.
    void toggle() {
        if (time_ >= duration_) return again();
        playing_ = !playing_;
    }
    /// Brings the torch, without the metal, to a time.
    void moveTo(double time) {
        time_ = std::clamp(time, 0.0, duration_);
        metalDue_ = metalDue_ || welds_;
        welds_ = false;
    }
    /// From the start, with the metal.
    void again() {
        time_ = 0;
        playing_ = welds_ = metalDue_ = true;
    }

    /// True once after each change that wants the metal as it was at first.
    bool takeMetalDue() { return std::exchange(metalDue_, false); }
    /// The torch has come to this time.
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
