// The lead of the lesson's torch: from mouse and keys at the desk to a hand that holds a torch, and back.
#pragma once

#include "app/activities/activity.hpp"
#include "app/session/controls.hpp"
#include "app/session/desk_torch.hpp"

#include <glm/mat3x3.hpp>

namespace meltpool {

enum class TorchLeader {
    none, ///< there is no metal
    desk, ///< mouse and keys, or a gamepad
    hand, ///< a TorchSource
    path, ///< of an expert or a kept attempt
};

class TorchLead {
  public:
    /// An attempt begins: the desk's torch stands where the lesson wants it.
    void begin(const Lesson& lesson) { desk_.begin(lesson); }
    /// `held`: from now on a hand leads the person's torch, else the desk.
    void take(bool held) { held_ = held; }
    TorchLeader leader(const Allowed& allowed) const;

    /// Takes what the desk does in this frame, see DeskTorch::update(). `toScreen`: see DeskFrame.
    void update(const Controls& controls, const glm::mat3& toScreen, double seconds, const ProcessSettings& process);
    /// The torch of the person at the end of step `step` of the frame's `steps`. Where another one leads it than in the
    /// last step, the arc goes out before the torch is elsewhere. `turn`: from the workpiece's frame to the room's.
    TorchSample next(const Trainer& trainer, const Controls& controls, const TorchSource& held, const glm::mat3& turn,
                     int step, int steps);

    /// The torch that mouse and keys lead, in a weld lesson.
    DeskTorch& desk() { return desk_; }
    const DeskTorch& desk() const { return desk_; }

  private:
    DeskTorch desk_;
    bool held_ = false;
    bool heldBefore_ = false; ///< in the last step
};

} // namespace meltpool
