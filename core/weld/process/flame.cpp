#include "core/weld/process/flame.hpp"

#include "core/weld/process/processes.hpp"

#include <algorithm>

namespace meltpool {

ParameterList describe(FlameSettings& s) {
    return {
        {"flame_power", "Flame", "W", &s.power, 0, 50000, "heat that reaches the metal"},
        {"sigma_mm", "Spread of the flame", "mm", &s.sigmaMm, 0.5, 20,
         "below 1.5 particle spacings the spot is coarse"},
    };
}

void Flame::apply(const ProcessSettings& settings) {
    settings_ = settings.of<Flame>();
}

/// The whole power goes to the surface around the axis, whatever its distance: hot gas follows the metal.
void Flame::advance(const TorchSample& torch, const MetalAhead&, double) {
    if (torch.trigger <= 0) return;
    const float trigger = std::min(torch.trigger, 1.0F);
    arc_.action = ArcAction::burning;
    arc_.share = trigger;
    arc_.radius = settings_.sigmaMm * 1e-3F;
    arc_.power = static_cast<double>(settings_.power * trigger);
    source_ = HeatSource::gaussian(torch.tip, torch.axis(), arc_.radius, static_cast<float>(arc_.power));
}

} // namespace meltpool
