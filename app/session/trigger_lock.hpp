// Keeps the heat off until the trigger (or the mouse's button) has been let go.
#pragma once

#include <string_view>

namespace meltpool {

/// Why the heat went out although the trigger was not let go.
enum class ArcOut {
    recentred,     ///< the workshop was brought before the person
    zoomed,        ///< the workpiece is shown at another size
    handChanged,   ///< the torch went to the other hand
    holderChanged, ///< from the controller to a tracker or back
    tableMoved,    ///< posture or height of the table
    tipJumped,     ///< faster than a hand moves
    torchLost,     ///< out of sight, or its controller is off
    runtimeLost,   ///< the headset's runtime has stopped or does not answer
    notFocused,    ///< the headset shows another program, or nobody wears it
    takenOver,     ///< by the mouse, or by the hand
    paused,        ///< the person looks around
    lessonBegan,   ///< or was reset
    panel,         ///< the trigger was pulled at the panel
    measuring,     ///< the torch's tip or direction
    redone,        ///< the attempt went back to an earlier moment
};

/// The word for records: "recentred", "zoomed" ...
std::string_view arcOutName(ArcOut reason);
/// The sentence for the person.
std::string_view arcOutSentence(ArcOut reason);

class TriggerLock {
  public:
    /// Travel of the trigger, 0..1, up to which it counts as let go.
    static constexpr float kLetGo = 0.05f;

    /// Puts the heat out. The first reason stays until the trigger is let go.
    void lock(ArcOut reason);
    /// The travel that counts in this frame. `seen`: it is measured now; a trigger that is not counts as neither pulled
    /// nor let go.
    float pass(float travel, bool seen = true);

    bool locked() const { return locked_; }
    /// The person pulls a locked trigger.
    bool holdsBack() const { return locked_ && pulled_; }
    ArcOut reason() const { return reason_; }

  private:
    ArcOut reason_ = ArcOut::lessonBegan;
    bool locked_ = false;
    bool pulled_ = false;
};

} // namespace meltpool
