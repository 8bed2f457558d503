#include "core/weld/process/soldering_iron.hpp"

#include "core/weld/process/processes.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr float kCoefficient = 2e4F; ///< W/(m² K) of a wetted tip. No source: chosen for 2-6 s a joint
constexpr float kPower = 80;         ///< W, of the iron itself
constexpr float kKelvin = 273.15F;

} // namespace

ParameterList describe(IronSettings& s) {
    return {
        {"tip_temperature_c", "Iron", "°C", &s.tipTemperatureC, 20, 1500, "temperature of the tip"},
        {"tip_radius_mm", "Iron's tip", "mm", &s.tipRadiusMm, 0.2, 20, "radius that touches the metal"},
    };
}

void SolderingIron::apply(const ProcessSettings& settings) {
    settings_ = settings.of<SolderingIron>();
}

void SolderingIron::advance(const TorchSample& torch, const MetalAhead& ahead, double) {
    if (torch.trigger <= 0) return;
    const float radius = touchRadius();
    source_ = HeatSource::hotTip(torch.tip, radius, settings_.tipTemperatureC + kKelvin, kCoefficient, kPower);
    arc_.share = std::clamp(1 - std::max(ahead.distance, 0.0F) / radius, 0.0F, 1.0F);
    if (arc_.share <= 0) return; // the source still heats what it touches beside the axis
    arc_.action = ArcAction::burning;
    arc_.radius = radius;
    arc_.power = static_cast<double>(kPower * arc_.share);
}

} // namespace meltpool
