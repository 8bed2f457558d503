#include "core/weld/process/flame.hpp"

#include "core/weld/process/processes.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;
/// Spacings by which heated metal is deeper off the axis than on it.
constexpr float kRelief = 3;
/// The pool of a flame is wide and slow.
constexpr FreezingRipples kRipples{4, 0.7F};

} // namespace

constinit const ProcessTraits Flame::kTraits{.name = kName, .torch = TorchShape::burner, .sound = {.roar = 0.10F}};

Equipment Flame::equipment(const FlameSettings& settings) {
    return {.rod = static_cast<double>(settings.rodDiameterMm) * 1e-3, .ripples = kRipples};
}

ParameterList describe(FlameSettings& s) {
    return {
        {"flame_power", "Flame", "W", &s.power, 0, 50000, "Heat to metal that catches the whole flame."},
        {"sigma_mm", "Spread of the flame", "mm", &s.sigmaMm, 0.5, 20,
         "Below 1.5 particle spacings the spot is coarse."},
        {"flame_length_mm", "Length of the flame", "mm", &s.lengthMm, 5, 200,
         "Length from the tip. Its second half heats less and less."},
        {"rod_diameter_mm", "Filler rod", "mm", &s.rodDiameterMm, 0, 5,
         "Rod in the other hand. Dip it into the pool. 0 is no rod."},
    };
}

void Flame::apply(const ProcessSettings& settings) {
    settings_ = settings.of<Flame>();
    setRod(static_cast<double>(settings_.rodDiameterMm * kMm));
}

TorchRay Flame::ray(const TorchSample& torch) const {
    return {torch.tip, torch.axis(), settings_.lengthMm * kMm};
}

/// Returns the share of the flame's heat that is left at a distance (m): all over the first half of its length, none at
/// its end.
float Flame::shareAt(float distance) const {
    return std::clamp(2 - 2 * distance / (settings_.lengthMm * kMm), 0.0F, 1.0F);
}

/// Heats the metal on the axis, or without any there the metal off the axis in front of the tip, each as far as it
/// catches the flame.
void Flame::advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) {
    if (torch.trigger <= 0) {
        meltRod(torch, nullptr, seconds);
        return;
    }
    const bool meets = std::isfinite(ahead.distance);
    const float distance = meets ? ahead.distance : 0;
    const float trigger = std::min(torch.trigger, 1.0F);
    arc_.action = ArcAction::burning;
    arc_.radius = settings_.sigmaMm * kMm;
    arc_.share = trigger * shareAt(distance);
    arc_.power = static_cast<double>(settings_.power * arc_.share);
    const auto length = static_cast<double>(meets ? distance : settings_.lengthMm * kMm / 2);
    const RodArc flame{ray(torch), length, static_cast<double>(arc_.radius), arc_.power};
    const double spent = meltRod(torch, &flame, seconds);
    const float shadow = meets ? 2 * arc_.radius + kRelief * metal_.spacing : settings_.lengthMm * kMm;
    source_ = HeatSource::gaussian(torch.tip + torch.axis() * distance, torch.axis(), arc_.radius,
                                   static_cast<float>(arc_.power - spent))
                  .inFront(distance, shadow)
                  .catching(1);
}

} // namespace meltpool
