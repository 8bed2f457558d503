#include "app/headset/torch_feedback.hpp"

#include <array>

namespace meltpool {

void TorchFeedback::update(const LessonSession& session, const TrackedTorch& torch, float strength, double elapsed) {
    time_ += elapsed;
    sounding_ = session.sounding();
    const TipGap gap = session.gap();
    if (torch.tracked())
        touch_.update(gap, sounding_, torch.velocity(), elapsed);
    else
        touch_.forget();
    const float trigger = session.held() ? torch.trigger() : 0.0f;
    feel_ = {time_, tipState(gap, trigger, sounding_), touch_.since(), touch_.speed()};
    feel_.state.liquid = sounding_.liquid;
    vibration_ = feel(feel_);
    vibration_.amplitude *= strength;
}

void TorchFeedback::play(xr::Headset& headset, const HeadsetHands& hands) {
    const TorchSelector& selector = hands.selector();
    if (holder_ != selector.holder() || hand_ != hands.torchHand()) send(headset, selector.tracker(), {});
    holder_ = selector.holder();
    hand_ = hands.torchHand();
    send(headset, selector.tracker(), vibration_);
}

void TorchFeedback::send(xr::Headset& headset, size_t tracker, const Vibration& vibration) const {
    const xr::HapticPulse pulse{vibration.amplitude, vibration.frequency, vibration.duration};
    if (holder_ == TorchHolder::tracker)
        headset.playTracker(tracker, pulse);
    else
        headset.play(hand_, pulse);
}

TipStatus TorchFeedback::status(unsigned pulses) const {
    static constexpr std::array<const char*, 5> kActions{"idle", "burning", "shorting", "stubbed", "breaking"};
    TipStatus status;
    status.action = kActions[static_cast<size_t>(feel_.state.action)];
    status.aheadMm = 1000.0 * static_cast<double>(sounding_.ahead);
    status.nearestMm = 1000.0 * static_cast<double>(sounding_.nearest);
    status.liquid = static_cast<double>(sounding_.liquid);
    status.touching = touch_.touching();
    status.touches = touch_.count();
    status.amplitude = static_cast<double>(vibration_.amplitude);
    status.frequency = static_cast<double>(vibration_.frequency);
    status.pulses = pulses;
    return status;
}

} // namespace meltpool
