// Turns a controller's or tracker's pose of each frame into torch samples for simulation steps of fixed length.
#pragma once

#include "app/headset/workshop.hpp"
#include "core/weld/torch/torch_sample.hpp"
#include "xr/input/input.hpp"
#include "xr/input/pivot.hpp"

#include <optional>

namespace meltpool {

class TrackedTorch {
  public:
    /// Takes the frame's pose and trigger. While it is not tracked the trigger is 0 and the torch stays at its last
    /// known pose. `elapsed`: real seconds since the last frame, for the tip's speed.
    void update(const xr::HandInput& hand, const xr::TipCalibration& calibration, const Workshop& workshop,
                double elapsed);
    /// The pose is no longer known, as in a frame that is not tracked.
    void lose() { tracked_ = false; }
    /// The trigger counts as released in this frame.
    void release() { trigger_ = 0; }

    bool tracked() const { return tracked_; }
    /// It was tracked at least once.
    bool known() const { return known_; }
    /// The tip in the workshop, for drawing.
    const xr::Pose& tip() const { return now_; }
    /// The grip in the workshop.
    const xr::Pose& grip() const { return grip_; }
    float trigger() const { return tracked_ ? trigger_ : 0.0f; }
    /// m/s, in the workshop.
    const glm::vec3& velocity() const { return velocity_; }

    /// The torch in the workpiece's frame for step `step` (from 0) of this frame's `steps`: poses at equal intervals
    /// between the last frame's pose and this one's. The caller sets the sample's time.
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
