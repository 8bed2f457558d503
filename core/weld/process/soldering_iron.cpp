#include "core/weld/process/soldering_iron.hpp"

#include "core/weld/process/processes.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr float kCoefficient = 2e4F; ///< W/(m² K) of a wetted tip. No source: chosen for 2-6 s a joint
constexpr float kPower = 80;         ///< W, power of the iron itself
constexpr float kKelvin = 273.15F;

} // namespace

constinit const ProcessTraits SolderingIron::kTraits{.name = kName, .torch = TorchShape::iron};

Equipment SolderingIron::equipment(const IronSettings& settings) {
    return {.rod = static_cast<double>(settings.rodDiameterMm) * 1e-3,
            .displays = {{{settings.tipTemperatureC, "\xC2\xB0"
                                                     "c"}}}};
}

ParameterList describe(IronSettings& s) {
    return {
        {"tip_temperature_c", "Iron", "°C", &s.tipTemperatureC, 20, 1500, "Temperature of the tip."},
        {"tip_radius_mm", "Iron's tip", "mm", &s.tipRadiusMm, 0.2, 20, "Radius of the contact with the metal."},
        {"rod_diameter_mm", "Wire solder", "mm", &s.rodDiameterMm, 0, 5,
         "Solder in the other hand. It melts in the pool and at the tip. 0 is none."},
    };
}

void SolderingIron::apply(const ProcessSettings& settings) {
    settings_ = settings.of<SolderingIron>();
    setRod(static_cast<double>(settings_.rodDiameterMm) * 1e-3);
}

/// Returns the W that the iron spends on the wire, if the wire meets the tip's ball or the pool that the tip melts. A
/// tip that is colder than the solder's liquidus melts none.
double SolderingIron::meltSolder(const TorchSample& torch, double seconds) {
    const auto radius = static_cast<double>(touchRadius());
    const RodArc tip{
        {torch.tip - torch.axis() * touchRadius(), torch.axis()}, 2 * radius, radius, static_cast<double>(kPower)};
    const double melts = metal_.table.temperatureAt(metal_.table.liquidusEnthalpy());
    const bool hot = torch.trigger > 0 && static_cast<double>(settings_.tipTemperatureC + kKelvin) > melts;
    return meltRod(torch, hot ? &tip : nullptr, seconds);
}

void SolderingIron::advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) {
    const double spent = meltSolder(torch, seconds);
    if (torch.trigger <= 0) return;
    const float radius = touchRadius();
    source_ = HeatSource::hotTip(torch.tip, radius, settings_.tipTemperatureC + kKelvin, kCoefficient,
                                 kPower - static_cast<float>(spent));
    arc_.share = std::clamp(1 - std::max(ahead.distance, 0.0F) / radius, 0.0F, 1.0F);
    if (arc_.share <= 0) return; // the source still heats metal that touches it off the axis
    arc_.action = ArcAction::burning;
    arc_.radius = radius;
    arc_.power = static_cast<double>(kPower * arc_.share);
}

} // namespace meltpool
