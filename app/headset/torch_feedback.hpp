// The vibration of the torch in the hand: what happens at its tip, and which device plays it.
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
    /// Has the controller or tracker that holds the torch vibrate; the one that held it before falls silent.
    void play(xr::Headset& headset, const HeadsetHands& hands);

    /// For the telemetry; `pulses`: how many vibrations the runtime has been sent.
    TipStatus status(unsigned pulses) const;

  private:
    void send(xr::Headset& headset, size_t tracker, const Vibration& vibration) const;

    double time_ = 0; ///< s
    SurfaceDistance surface_;
    TipTouch touch_;
    TipFeel feel_;
    Vibration vibration_;
    TorchHolder holder_ = TorchHolder::hand; ///< vibrated last
    xr::Hand hand_ = xr::Hand::right;        ///< vibrated last
};

} // namespace meltpool
