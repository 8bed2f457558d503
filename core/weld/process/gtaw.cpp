#include "core/weld/process/gtaw.hpp"

#include "core/gl/state_archive.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/process/shielding_gas.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr double kFallVoltage = 9;    // V
constexpr double kVoltagePerMm = 0.9; // V/mm
constexpr double kVoltagePerAmpere = 0.01;
constexpr double kLoadLineVoltage = 10;  // V, IEC 60974-1
constexpr double kLoadLineSlope = 0.04;  // V/A
constexpr double kMachineReserve = 1.35; // times the load line, at which the arc goes out
constexpr float kStrikeGap = 4e-3F;      // m that the high-frequency spark jumps; trade knowledge, no document checked
constexpr float kTouch = 0.25e-3F;       // m: accuracy with which the surface is known

/// Only the rod falls into this pool, and its dips show in the freezing times themselves.
constexpr FreezingRipples kRipples{6, 0.7F};

constexpr std::array kRetired{
    RetiredSetting{"voltage", "the voltage follows from the arc's length"},
    kRetiredEfficiency,
    kRetiredSigma,
    RetiredSetting{"arc_length_mm", "the arc's length is the distance of the torch from the metal"},
};

double loadLine(double current) {
    return kLoadLineVoltage + kLoadLineSlope * current;
}

} // namespace

constinit const ProcessTraits Gtaw::kTraits{
    .name = kName,
    .formerName = "tig",
    .arc = true,
    .distance = DistanceKind::arcLength,
    .striking = Striking::spark,
    .shielding = Shielding::gas,
    .torch = TorchShape::tungstenTorch,
    .efficiency = 0.6,
    .alternating = 100, // no source: chosen
    // Rule of thumb for the gas: a second for each 10 A, at least five; no document was checked.
    .sound = {.quiet = 0.016F,
              .loud = 0.070F,
              .lowPitch = 1400,
              .highPitch = 6500,
              .scratches = true,
              .postFlow = 5,
              .postFlowPerAmpere = 0.1},
    .retired = kRetired};

Equipment Gtaw::equipment(const GtawSettings& settings) {
    return {.rod = static_cast<double>(settings.rodDiameterMm) * kMm,
            .ripples = kRipples,
            .displays = {{{settings.current, "a"}}},
            .gas = &shieldingGas(GasKind::ar)};
}

ParameterList describe(GtawSettings& s) {
    return {
        {"current", "Current", "A", &s.current, 5, 500, "The machine holds it. More current melts deeper."},
        {"electrode_diameter_mm", "Electrode", "mm", &s.electrodeDiameterMm, 0.5, 6.4, "tungsten"},
        {"rod_diameter_mm", "Filler rod", "mm", &s.rodDiameterMm, 0, 5,
         "Rod in the other hand. Dip it into the pool. 0 is no rod."},
        {"gas", "Gas", "", &s.gas, 0, 0, "Argon.", shieldingGasNames().subspan(static_cast<size_t>(GasKind::ar), 1)},
    };
}

double gtawVoltage(double length, double current) {
    return kFallVoltage + kVoltagePerMm * std::max(length, 0.0) / kMm + kVoltagePerAmpere * current;
}

double gtawLongestArc(double current) {
    const double left = kMachineReserve * loadLine(current) - gtawVoltage(0, current);
    return std::max(left, 0.0) / kVoltagePerMm * kMm;
}

void Gtaw::apply(const ProcessSettings& settings) {
    settings_ = settings.of<Gtaw>();
    setRod(static_cast<double>(settings_.rodDiameterMm) * kMm);
}

void Gtaw::reset() {
    RodProcess::reset();
    noArc_ = NoArc::released;
    released_ = true;
    spoiled_ = false;
}

void Gtaw::transfer(gl::StateArchive& archive) {
    RodProcess::transfer(archive);
    archive.values(noArc_, released_, spoiled_);
}

/// Returns the reason why this step has no arc, the trigger pulled.
NoArc Gtaw::whyNot(const TorchSample& torch, const MetalAhead& ahead, double current) const {
    const bool lit = noArc_ == NoArc::burns;
    if (!lit && !released_) return noArc_;
    if (!std::isfinite(ahead.distance)) return lit ? NoArc::metalLeft : NoArc::noMetal;
    if (ahead.distance <= kTouch) return lit ? NoArc::touched : NoArc::touching;
    if (rodTouches(torch, static_cast<double>(settings_.electrodeDiameterMm) * kMm))
        return lit ? NoArc::touched : NoArc::touching;
    if (!lit && ahead.distance > kStrikeGap) return NoArc::tooFar;
    if (static_cast<double>(ahead.distance) > gtawLongestArc(current)) return lit ? NoArc::tooLong : NoArc::tooFar;
    return NoArc::burns;
}

void Gtaw::advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) {
    strikeOrBurn(torch, ahead);
    const RodArc arc{ray(torch), static_cast<double>(arc_.length), static_cast<double>(arc_.radius), arc_.power};
    const double spent = meltRod(torch, arc_.burns() ? &arc : nullptr, seconds);
    if (arc_.burns()) heatSurface(ray(torch), arc_.power - spent);
}

void Gtaw::strikeOrBurn(const TorchSample& torch, const MetalAhead& ahead) {
    if (torch.trigger <= 0) {
        arc_.noArc = noArc_ = NoArc::released;
        released_ = true;
        return;
    }
    const bool strikes = noArc_ != NoArc::burns;
    const double current = static_cast<double>(settings_.current * std::min(torch.trigger, 1.0F));
    arc_.noArc = noArc_ = whyNot(torch, ahead, current);
    if (noArc_ == NoArc::touched) spoiled_ = true;
    if (noArc_ != NoArc::burns) return;
    released_ = false;
    const auto length = static_cast<double>(ahead.distance);
    const double voltage = gtawVoltage(length, current);
    const double breaking = loadLine(current);
    arc_.action = strikes ? ArcAction::striking : voltage > breaking ? ArcAction::breaking : ArcAction::burning;
    arc_.length = ahead.distance;
    arc_.current = static_cast<float>(current);
    arc_.voltage = static_cast<float>(voltage);
    arc_.power = kGtawEfficiency * voltage * current;
    arc_.radius = static_cast<float>(arcHeatRadius(length, current));
    pressSurface(current, static_cast<double>(arc_.radius));
    arc_.share = std::min(torch.trigger, 1.0F);
    const double atRest = gtawVoltage(2 * kMm, current);
    arc_.stretch = static_cast<float>(std::clamp((voltage - atRest) / std::max(breaking - atRest, 0.1), 0.0, 1.0));
}

} // namespace meltpool
