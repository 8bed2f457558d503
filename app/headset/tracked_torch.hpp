// Turns a controller's or tracker's pose of each frame into torch samples for simulation steps of fixed length.
#pragma once

#include "app/headset/workshop.hpp"
#include "app/session/trigger_lock.hpp"
#include "core/scene/gloved_hand.hpp"
#include "core/weld/torch/torch_sample.hpp"
#include "xr/input.hpp"
#include "xr/pivot.hpp"

#include <optional>

namespace meltpool {

/// A hand of the person, in the workshop.
struct HandPose {
    xr::Pose hold;              ///< see xr::HandInput::hold
    glm::vec3 forearm{0, 0, 1}; ///< unit vector from the wrist to the elbow
    bool right = false;

    /// Returns the hand for drawing: its back is on the outer side of the hold.
    TrackedHand tracked() const;
};

/// Returns the pose of a controller's hand. Nothing measures the forearm: it leads back from the pointer and a little
/// down.
HandPose handPose(const xr::HandInput& hand, const Workshop& workshop, bool right);

/// Returns the forearm's direction for a head there: the elbow is where an arm of usual lengths from the shoulder has
/// it, on the side to which HandPose::forearm leads.
glm::vec3 forearmFrom(const xr::Pose& head, const HandPose& hand);

class TrackedTorch {
  public:
    /// Fastest tip in the workshop, m/s. Welding hands move at up to 0.2 m/s, fast reaching ones peak at 3 m/s; a
    /// faster one is an error of the tracking or a flick, and no weld follows it.
    static constexpr float kFastestHand = 4.0f;

    /// Takes the frame's pose and trigger. While it is not tracked the trigger is 0 and the torch stays at its last
    /// known pose. A tip that is faster than kFastestHand is at its new place without a path to it. The loss of the
    /// torch, and such a jump with the trigger pulled, put the arc out. `elapsed`: real seconds since the last frame.
    void update(const xr::HandInput& hand, const xr::TipCalibration& calibration, const Workshop& workshop,
                double elapsed);
    /// Loses the pose, as in a frame without tracking.
    void lose(ArcOut reason);
    /// Puts the arc out until the trigger is released while the torch is tracked. The cause may have moved the torch in
    /// the workpiece's frame, so no sample is made between its old and its new place.
    void putOut(ArcOut reason);
    /// Forgets the last sample when a lesson begins.
    void forgetSample() { last_.reset(); }

    bool tracked() const { return tracked_; }
    /// Returns true if it was tracked at least once.
    bool known() const { return known_; }
    /// Tip in the workshop, for drawing.
    const xr::Pose& tip() const { return now_; }
    /// End of an electrode of which `burnt` (m of the workshop) has burned off, in the workshop; else the tip.
    glm::vec3 end(float burnt) const { return now_ * glm::vec3(0, 0, burnt); }
    float trigger() const { return tracked_ && !lock_.locked() ? trigger_ : 0.0f; }
    const TriggerLock& triggerLock() const { return lock_; }
    /// Velocity in the workshop, m/s.
    const glm::vec3& velocity() const { return velocity_; }

    /// Current torch in the workpiece's frame. The caller sets the sample's time.
    TorchSample sample(const WorkpiecePlace& place) const;
    /// Torch for step `step` (from 0) of this frame's `steps`: poses at equal intervals between the last frame's pose
    /// and this one's. The first one after putOut() is the last one before it with the trigger released, so that the
    /// arc is out before the torch is elsewhere.
    TorchSample next(const WorkpiecePlace& place, int step, int steps);

  private:
    TorchSample sampleAt(const xr::Pose& tip, const WorkpiecePlace& place) const;

    xr::Pose before_;
    xr::Pose now_;
    TriggerLock lock_;
    std::optional<TorchSample> last_; ///< torch of the last step
    float trigger_ = 0;
    glm::vec3 velocity_{0.0f};
    bool tracked_ = false;
    bool known_ = false;
    bool jumped_ = false; ///< the next sample has no predecessor
};

} // namespace meltpool
