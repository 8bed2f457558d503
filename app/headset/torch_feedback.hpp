// Plays the vibration of the torch in the hand: chooses the events at its tip and the device.
#pragma once

#include "app/headset/headset_hands.hpp"
#include "app/session/headset_status.hpp"
#include "app/session/lesson_session.hpp"
#include "core/training/feedback/haptics.hpp"
#include "core/weld/process/tip_touch.hpp"
#include "xr/headset.hpp"

namespace meltpool {

class TorchFeedback {
  public:
    /// Takes the lesson's newest knowledge of the metal at the tip of the torch. `strength`: factor on the amplitude.
    /// `elapsed`: real seconds since the last frame.
    void update(const LessonSession& session, const TrackedTorch& torch, float strength, double elapsed);
    /// Vibrates the controller or tracker that holds the torch; silences the one that held it before.
    void play(xr::Headset& headset, const HeadsetHands& hands);

    /// Returns the state for the telemetry; `pulses`: number of vibrations sent to the runtime.
    TipStatus status(unsigned pulses) const;

  private:
    void send(xr::Headset& headset, size_t tracker, const Vibration& vibration) const;

    double time_ = 0; ///< s
    SurfaceDistance surface_;
    TipTouch touch_;
    TipFeel feel_;
    Vibration vibration_;
    TorchHolder holder_ = TorchHolder::hand; ///< holder that vibrated last
    xr::Hand hand_ = xr::Hand::right;        ///< hand that vibrated last
};

} // namespace meltpool
