#include "app/headset/tracked_torch.hpp"

namespace meltpool {

void TrackedTorch::update(const xr::HandInput& hand, const xr::TipCalibration& calibration, const Workshop& workshop,
                          double elapsed) {
    const bool continues = tracked_;
    tracked_ = hand.tracked;
    before_ = now_;
    velocity_ = glm::vec3(0.0f);
    if (!hand.tracked) return;
    grip_ = workshop.toWorkshop(hand.grip);
    now_ = calibration.tip(grip_);
    trigger_ = hand.trigger;
    known_ = true;
    // A torch that is tracked again starts at its new place; it does not travel there from where it was lost.
    if (!continues) before_ = now_;
    if (elapsed > 0) velocity_ = (now_.position - before_.position) / static_cast<float>(elapsed);
}

TorchSample TrackedTorch::sample(const WorkpiecePlace& place, int step, int steps) const {
    const float t = static_cast<float>(step + 1) / static_cast<float>(steps > 0 ? steps : 1);
    const xr::Pose tip = xr::interpolate(before_, now_, t);
    TorchSample sample;
    sample.tip = place.toWorkpiece(tip.position);
    sample.orientation = glm::normalize(tip.orientation);
    sample.trigger = trigger();
    return sample;
}

} // namespace meltpool
