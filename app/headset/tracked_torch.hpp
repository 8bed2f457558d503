// The torch in the tracked hand: from the controller's poses, frame by frame, to torch samples for fixed simulation
// steps.
#pragma once

#include "app/headset/workshop.hpp"
#include "core/weld/torch/torch_sample.hpp"
#include "xr/input/input.hpp"
#include "xr/input/pivot.hpp"

#include <optional>

namespace meltpool {

class TrackedTorch {
  public:
    /// Takes the frame's hand. Where it is not tracked the arc goes out at once and the torch stays where it was last
    /// seen. `elapsed`: real seconds since the last frame, for the tip's speed.
    void update(const xr::HandInput& hand, const xr::TipCalibration& calibration, const Workshop& workshop,
                double elapsed);
    /// The headset is gone: as a lost hand.
    void lose() { tracked_ = false; }
    /// The trigger is for something else in this frame.
    void release() { trigger_ = 0; }

    bool tracked() const { return tracked_; }
    /// It was held at least once.
    bool known() const { return known_; }
    /// The tip in the workshop, for drawing.
    const xr::Pose& tip() const { return now_; }
    /// The grip in the workshop.
    const xr::Pose& grip() const { return grip_; }
    float trigger() const { return tracked_ ? trigger_ : 0.0f; }
    /// m/s, in the workshop.
    const glm::vec3& velocity() const { return velocity_; }

    /// The torch in the workpiece's frame for step `step` (from 0) of the `steps` that this frame runs: the way between
    /// the last frame's place and this one's in even parts. The time is left to the caller.
    TorchSample sample(const WorkpiecePlace& place, int step, int steps) const;

  private:
    xr::Pose before_;
    xr::Pose now_;
    xr::Pose grip_;
    float trigger_ = 0;
    glm::vec3 velocity_{0.0f};
    bool tracked_ = false;
    bool known_ = false;
};

} // namespace meltpool
