#include "app/headset/torch_feedback.hpp"

namespace meltpool {

void TorchFeedback::update(const LessonSession& session, const TrackedTorch& torch, float strength, double elapsed) {
    time_ += elapsed;
    const Trainer* trainer = session.run().trainer();
    surface_ = session.run().surfaceDistance();
    if (torch.tracked())
        touch_.update(trainer == nullptr ? 0 : trainer->metal().model().touchRadius(), surface_, torch.velocity(),
                      elapsed);
    else
        touch_.forget();
    const bool welds = session.leader() == TorchLeader::hand && torch.trigger() > 0;
    feel_ = {time_, welds ? session.run().arc() : ArcState{}, touch_.since(), touch_.speed()};
    feel_.shorts = trainer == nullptr ? 0 : trainer->heard().shortPhase;
    feel_.arc.liquid = surface_.liquid;
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
    TipStatus status;
    status.action = arcActionName(feel_.arc.action);
    status.aheadMm = 1000.0 * static_cast<double>(surface_.ahead);
    status.nearestMm = 1000.0 * static_cast<double>(surface_.nearest);
    status.liquid = static_cast<double>(surface_.liquid);
    status.touching = touch_.touching();
    status.touches = touch_.count();
    status.amplitude = static_cast<double>(vibration_.amplitude);
    status.frequency = static_cast<double>(vibration_.frequency);
    status.pulses = pulses;
    return status;
}

} // namespace meltpool
