#include "core/weld/process/process.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 4> kKinds{"flame", "tig", "gmaw", "iron"};
constexpr float kMm = 1e-3F;
constexpr double kKelvin = 273.15;
constexpr float kIronCoefficient = 2e4F; ///< W/(m² K) of a wetted soldering tip; none: chosen for 2-6 s a joint
constexpr float kIronPower = 80;         ///< W, of the iron itself

ProcessKind kindOf(const ProcessParameters& p) {
    return static_cast<ProcessKind>(p.kind);
}

} // namespace

ParameterList describe(ProcessParameters& p) {
    return {
        {"process", "Process", "", &p.kind, 0, 3, "what the torch is", kKinds},
        {"voltage", "Voltage", "V", &p.voltage, 1, 60, "arc; more makes the bead wider"},
        {"current", "Current", "A", &p.current, 1, 800, "arc; more melts deeper"},
        {"efficiency", "Arc efficiency", "", &p.efficiency, 0.1, 1,
         "share of V I that reaches the metal: TIG 0.6, GMAW 0.8"},
        {"flame_power", "Flame", "W", &p.flamePower, 0, 50000, "heat that reaches the metal"},
        {"sigma_mm", "Spread of the heat", "mm", &p.sigmaMm, 0.5, 20, "below 1.5 particle spacings the spot is coarse"},
        {"wire_diameter_mm", "Wire diameter", "mm", &p.wireDiameterMm, 0.3, 5, "GMAW"},
        {"wire_feed_m_min", "Wire feed", "m/min", &p.wireFeedMPerMin, 0, 30, "GMAW"},
        {"drop_temperature_c", "Drop temperature", "°C", &p.dropTemperatureC, 0, 4000,
         "at which wire arrives in the pool"},
        {"drop_speed", "Drop speed", "m/s", &p.dropSpeed, 0.05, 2, "fast drops splash"},
        {"tip_temperature_c", "Iron", "°C", &p.tipTemperatureC, 20, 1500, "soldering iron"},
        {"tip_radius_mm", "Iron's tip", "mm", &p.tipRadiusMm, 0.2, 20, "soldering iron"},
        {"arc_length_mm", "Arc length", "mm", &p.arcLengthMm, 0.5, 20,
         "arcs: the right one, TIG 1.5-3; the hand feels a shorter or longer one"},
    };
}

double processPower(const ProcessParameters& p) {
    switch (kindOf(p)) {
    case ProcessKind::Flame:
        return static_cast<double>(p.flamePower);
    case ProcessKind::Iron:
        return static_cast<double>(kIronPower);
    default:
        return static_cast<double>(p.efficiency) * static_cast<double>(p.voltage) * static_cast<double>(p.current);
    }
}

double wireRate(const ProcessParameters& p) {
    if (kindOf(p) != ProcessKind::Gmaw) return 0;
    const double diameter = static_cast<double>(p.wireDiameterMm) * 1e-3;
    return std::numbers::pi / 4 * diameter * diameter * static_cast<double>(p.wireFeedMPerMin) / 60;
}

WeldProcess::WeldProcess(const HeatTable& table, double density, float spacing, float ambient)
    : table_(table), density_(density), ambient_(ambient), filler_(spacing) {}

double WeldProcess::wirePower() const {
    const double gained = table_.enthalpyAt(static_cast<double>(parameters.dropTemperatureC) + kKelvin) -
                          table_.enthalpyAt(static_cast<double>(ambient_));
    return wireRate(parameters) * density_ * std::max(gained, 0.0);
}

std::span<const HeatSource> WeldProcess::sources(const TorchSample& torch) {
    if (torch.trigger <= 0) return {};
    const auto trigger = static_cast<double>(torch.trigger);
    if (kindOf(parameters) == ProcessKind::Iron) {
        source_ =
            HeatSource::hotTip(torch.tip, parameters.tipRadiusMm * kMm,
                               parameters.tipTemperatureC + static_cast<float>(kKelvin), kIronCoefficient, kIronPower);
    } else {
        const double power = std::max(processPower(parameters) - wirePower(), 0.0) * trigger;
        source_ = HeatSource::gaussian(torch.tip, torch.axis(), parameters.sigmaMm * kMm, static_cast<float>(power));
    }
    return {&source_, 1};
}

ArcPressure WeldProcess::pressure(const TorchSample& torch) const {
    const ProcessKind kind = kindOf(parameters);
    if (torch.trigger <= 0 || (kind != ProcessKind::Tig && kind != ProcessKind::Gmaw)) return {};
    const float sigma = parameters.sigmaMm * kMm;
    const double peak =
        arcPressurePeak(static_cast<double>(parameters.current * torch.trigger), static_cast<double>(sigma));
    return {torch.tip, torch.axis(), sigma, static_cast<float>(peak)};
}

std::span<const MetalSeed> WeldProcess::feed(const TorchSample& torch, double seconds) {
    if (torch.trigger <= 0) return {};
    const double volume = wireRate(parameters) * static_cast<double>(torch.trigger) * seconds;
    return filler_.feed(volume, torch.tip, torch.axis() * parameters.dropSpeed,
                        parameters.dropTemperatureC + static_cast<float>(kKelvin));
}

} // namespace meltpool
