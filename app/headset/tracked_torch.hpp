// Turns a controller's or tracker's pose of each frame into torch samples for simulation steps of fixed length.
#pragma once

#include "app/headset/workshop.hpp"
#include "app/session/trigger_lock.hpp"
#include "core/weld/torch/torch_sample.hpp"
#include "xr/input.hpp"
#include "xr/pivot.hpp"

#include <optional>

namespace meltpool {

class TrackedTorch {
  public:
    /// m/s of the tip in the workshop. Welding hands move at up to 0.2 m/s, fast reaching ones peak at 3 m/s; what is
    /// faster is an error of the tracking or a flick, and no weld follows it.
    static constexpr float kFastestHand = 4.0f;

    /// Takes the frame's pose and trigger. While it is not tracked the trigger is 0 and the torch stays at its last
    /// known pose. A tip that is faster than kFastestHand is at its new place without a way to it. Losing the torch and
    /// such a jump with the trigger pulled put the arc out. `elapsed`: real seconds since the last frame.
    void update(const xr::HandInput& hand, const xr::TipCalibration& calibration, const Workshop& workshop,
                double elapsed);
    /// The pose is no longer known, as in a frame that is not tracked.
    void lose(ArcOut reason);
    /// The arc is out until the trigger has been let go while the torch is tracked. What happened may have moved the
    /// torch in the workpiece's frame, so no sample lies between its old and its new place.
    void putOut(ArcOut reason);
    /// There is no last sample: a lesson begins.
    void forgetSample() { last_.reset(); }

    bool tracked() const { return tracked_; }
    /// It was tracked at least once.
    bool known() const { return known_; }
    /// The tip in the workshop, for drawing.
    const xr::Pose& tip() const { return now_; }
    /// The grip in the workshop.
    const xr::Pose& grip() const { return grip_; }
    float trigger() const { return tracked_ && !lock_.locked() ? trigger_ : 0.0f; }
    const TriggerLock& triggerLock() const { return lock_; }
    /// m/s, in the workshop.
    const glm::vec3& velocity() const { return velocity_; }

    /// The torch in the workpiece's frame as it is now. The caller sets the sample's time.
    TorchSample sample(const WorkpiecePlace& place) const;
    /// The torch for step `step` (from 0) of this frame's `steps`: poses at equal intervals between the last frame's
    /// pose and this one's. The first one after putOut() is the last one before it with the trigger let go, so that the
    /// arc is out before the torch is elsewhere.
    TorchSample next(const WorkpiecePlace& place, int step, int steps);

  private:
    TorchSample sampleAt(const xr::Pose& tip, const WorkpiecePlace& place) const;

    xr::Pose before_;
    xr::Pose now_;
    xr::Pose grip_;
    TriggerLock lock_;
    std::optional<TorchSample> last_; ///< of the last step
    float trigger_ = 0;
    glm::vec3 velocity_{0.0f};
    bool tracked_ = false;
    bool known_ = false;
    bool jumped_ = false; ///< the next sample follows upon no other
};

} // namespace meltpool
