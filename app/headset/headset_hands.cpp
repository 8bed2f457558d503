#include "app/headset/headset_hands.hpp"

#include "app/headset/workshop_scene.hpp"
#include "core/base/words.hpp"

namespace meltpool {

HeadsetHands::HeadsetHands(const HeadsetParameters& parameters, const std::filesystem::path& folder)
    : parameters_(parameters),
      calibrations_{CalibrationFile(folder / "torch-tip.txt"), CalibrationFile(folder / "torch-tip-tracker.txt")} {}

xr::Hand HeadsetHands::torchHand() const {
    return parameters_.hand == HeadsetParameters::kLeft ? xr::Hand::left : xr::Hand::right;
}

void HeadsetHands::update(const xr::Input& input, const Workshop& workshop, double elapsed) {
    updateTorch(input, workshop, elapsed);
    const xr::HandInput& other = input.hand(torchHand() == xr::Hand::right ? xr::Hand::left : xr::Hand::right);
    rod_ = other.tracked ? std::optional(workshop.toWorkshop(other.grip)) : std::nullopt;
    if (measuring_.underWay()) putOut(ArcOut::measuring);
}

void HeadsetHands::updateTorch(const xr::Input& input, const Workshop& workshop, double elapsed) {
    const bool onTracker = parameters_.torchOn == HeadsetParameters::kTracker;
    selector_.update(onTracker, input.hand(torchHand()), input.trackers(), elapsed);
    if (selector_.changed()) putOut(ArcOut::holderChanged);
    CalibrationFile& calibration = calibrations_[size_t(selector_.holder())];
    torch_.update(selector_.torch(), calibration.tip(), workshop, elapsed);
    if (const auto measured = measuring_.gather(selector_.torch(), calibration.tip(), elapsed))
        measuring_.kept(calibration.keep(*measured));
}

TorchSample HeadsetHands::sample(const WorkpiecePlace& place) const {
    return withRod(torch_.sample(place), place);
}

TorchSample HeadsetHands::next(const WorkpiecePlace& place, int step, int steps) {
    return withRod(torch_.next(place, step, steps), place);
}

TorchSample HeadsetHands::withRod(TorchSample sample, const WorkpiecePlace& place) const {
    if (rod_) {
        const glm::vec3 tip = *rod_ * glm::vec3(0, 0, -WorkshopScene::kRodReach);
        sample.rod = RodSample{place.toWorkpiece(tip), place.toWorkpiece(glm::normalize(rod_->orientation))};
    }
    return sample;
}

std::string_view HeadsetHands::warning() const {
    if (!selector_.warning().empty()) return selector_.warning();
    if (torch_.known() && !torch_.tracked()) return phrase("headset.torch.lost");
    return {};
}

} // namespace meltpool
