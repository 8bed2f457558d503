// The lock that keeps the heat off until the trigger (or the mouse's button) is released.
#pragma once

#include <string_view>

namespace meltpool {

/// Reasons why the heat went out although the trigger was not released.
enum class ArcOut {
    recentred,     ///< the workshop was centred on the person
    zoomed,        ///< the workpiece is shown at another size
    handChanged,   ///< the torch went to the other hand
    holderChanged, ///< from the controller to a tracker or back
    tableMoved,    ///< the table's height changed
    tipJumped,     ///< the tip jumped faster than a hand moves
    torchLost,     ///< the torch is out of sight, or its controller is off
    runtimeLost,   ///< the headset's runtime has stopped or does not answer
    notFocused,    ///< the headset shows another program, or is not worn
    takenOver,     ///< the mouse, or the hand, took over
    paused,        ///< the person looks around
    lessonBegan,   ///< the lesson began or was reset
    panel,         ///< the trigger was pulled at the panel
    measuring,     ///< the torch's tip or direction is measured
    redone,        ///< the attempt went back to an earlier checkpoint
};

/// Word for records: "recentred", "zoomed" ...
std::string_view arcOutName(ArcOut reason);
/// Sentence for the person.
std::string_view arcOutSentence(ArcOut reason);

/// Makes a switch of a trigger: on above kOn, off again below kOff.
class TriggerSwitch {
  public:
    static constexpr float kOn = 0.3f, kOff = 0.2f; ///< travel, 0..1

    /// Returns 1 while on, else 0.
    float pass(float travel) {
        on_ = travel > (on_ ? kOff : kOn);
        return on_ ? 1.0f : 0.0f;
    }

  private:
    bool on_ = false;
};

class TriggerLock {
  public:
    /// Travel of the trigger, 0..1, up to which it counts as released.
    static constexpr float kLetGo = 0.05f;

    /// Puts the heat out. The first reason stays until the trigger is released, or a lesson begins.
    void lock(ArcOut reason);
    /// Returns the travel that counts in this frame. `seen`: it is measured now; an unmeasured trigger counts as
    /// neither pulled nor released.
    float pass(float travel, bool seen = true);

    bool locked() const { return locked_; }
    /// True while the person pulls a locked trigger.
    bool holdsBack() const { return locked_ && pulled_; }
    ArcOut reason() const { return reason_; }

  private:
    ArcOut reason_ = ArcOut::lessonBegan;
    bool locked_ = false;
    bool pulled_ = false;
};

} // namespace meltpool
