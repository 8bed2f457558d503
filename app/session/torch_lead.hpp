// The leader of the lesson's torch: mouse and keys at the desk, a hand that holds a torch, or a path.
#pragma once

#include "app/activities/activity.hpp"
#include "app/session/controls.hpp"
#include "app/session/desk_torch.hpp"

#include <glm/mat3x3.hpp>

namespace meltpool {

enum class TorchLeader {
    none, ///< no metal
    desk, ///< mouse and keys, or a gamepad
    hand, ///< a TorchSource
    path, ///< an expert's or a stored attempt's
};

class TorchLead {
  public:
    /// Begins an attempt: places the desk's torch at the lesson's start.
    void begin(const Lesson& lesson) {
        desk_.begin(lesson);
        switch_ = {};
    }
    /// `held`: a hand leads the person's torch from now on, otherwise the desk.
    void take(bool held) { held_ = held; }
    TorchLeader leader(const Allowed& allowed) const;

    /// Takes the desk's input of this frame, see DeskTorch::update(). `toScreen`, `seconds`: see DeskFrame.
    void update(const Controls& controls, const glm::mat3& toScreen, double seconds, const ProcessSettings& process);
    /// Torch of the person at the end of step `step` of the frame's `steps`. If its leader changed since the last step,
    /// the arc goes out before the torch moves. `turn`: from the workpiece's frame to the room's.
    TorchSample next(const Trainer& trainer, const Controls& controls, const TorchSource& held, const glm::mat3& turn,
                     int step, int steps);

    /// Torch that mouse and keys lead, in a weld lesson.
    DeskTorch& desk() { return desk_; }
    const DeskTorch& desk() const { return desk_; }

  private:
    TorchSample personal(const Trainer& trainer, const Controls& controls, const TorchSource& held,
                         const glm::mat3& turn, int step, int steps);

    DeskTorch desk_;
    TriggerSwitch switch_;
    bool held_ = false;
    bool heldBefore_ = false; ///< leader at the last step
};

} // namespace meltpool
