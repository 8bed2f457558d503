#include "app/headset/headset_hands.hpp"

#include "app/headset/workshop_scene.hpp"
#include "core/base/words.hpp"

namespace meltpool {

namespace {

/// Returns the tip of a torch of these lengths in the frame of the hand's grip: its handle runs through the hold.
xr::TipCalibration ownTip(const TorchGeometry& geometry, const xr::HandInput& hand) {
    const xr::Pose inGrip = hand.grip.inverse() * hand.hold * xr::Pose{geometry.tipOrientation(), geometry.tip()};
    return {inGrip.position, inGrip.orientation, 0};
}

} // namespace

HeadsetHands::HeadsetHands(const HeadsetParameters& parameters, const std::filesystem::path& folder)
    : parameters_(parameters),
      calibrations_{CalibrationFile(folder / "torch-tip.txt"), CalibrationFile(folder / "torch-tip-tracker.txt")} {}

xr::Hand HeadsetHands::torchHand() const {
    return parameters_.hand == HeadsetParameters::kLeft ? xr::Hand::left : xr::Hand::right;
}

void HeadsetHands::update(const std::array<const xr::HandInput*, 2>& controllers,
                          std::span<const xr::TrackerInput> trackers, const Workshop& workshop,
                          const TorchGeometry& geometry, double elapsed) {
    const bool right = torchHand() == xr::Hand::right;
    updateTorch(*controllers[right ? 1 : 0], trackers, workshop, geometry, elapsed);
    const xr::HandInput& other = *controllers[right ? 0 : 1];
    otherAlone_ = other.tracked && !selector_.torch().present;
    rod_ = other.tracked ? std::optional(handPose(other, workshop, !right)) : std::nullopt;
    if (measuring_.underWay()) putOut(ArcOut::measuring);
}

void HeadsetHands::updateTorch(const xr::HandInput& hand, std::span<const xr::TrackerInput> trackers,
                               const Workshop& workshop, const TorchGeometry& geometry, double elapsed) {
    const bool onTracker = parameters_.torchOn == HeadsetParameters::kTracker;
    selector_.update(onTracker, hand, trackers, elapsed);
    if (selector_.changed()) putOut(ArcOut::holderChanged);
    CalibrationFile& calibration = calibrations_[size_t(selector_.holder())];
    const xr::HandInput& torch = selector_.torch();
    const xr::TipCalibration tip = calibration.measured() ? calibration.tip() : ownTip(geometry, torch);
    torch_.update(torch, tip, workshop, elapsed);
    if (torch.tracked) holder_ = handPose(torch, workshop, torchHand() == xr::Hand::right);
    if (const auto measured = measuring_.gather(torch, tip, elapsed)) measuring_.kept(calibration.keep(*measured, tip));
}

void HeadsetHands::useOwnTip() {
    putOut(ArcOut::measuring);
    measuring_.forgotten(calibrations_[size_t(selector_.holder())].forget());
}

TorchSample HeadsetHands::sample(const WorkpiecePlace& place) const {
    return withRod(torch_.sample(place), place);
}

TorchSample HeadsetHands::next(const WorkpiecePlace& place, int step, int steps) {
    return withRod(torch_.next(place, step, steps), place);
}

TorchSample HeadsetHands::withRod(TorchSample sample, const WorkpiecePlace& place) const {
    if (rod_) {
        const glm::vec3 tip = rod_->hold * glm::vec3(0, 0, -WorkshopScene::kRodReach);
        sample.rod = RodSample{place.toWorkpiece(tip), place.toWorkpiece(glm::normalize(rod_->hold.orientation))};
    }
    return sample;
}

std::string_view HeadsetHands::warning() const {
    if (!selector_.warning().empty()) return selector_.warning();
    if (torch_.known() && !torch_.tracked()) return phrase("headset.torch.lost");
    if (otherAlone_ && !torch_.known())
        return phrase(torchHand() == xr::Hand::right ? "headset.torch.only_left" : "headset.torch.only_right");
    return {};
}

} // namespace meltpool
