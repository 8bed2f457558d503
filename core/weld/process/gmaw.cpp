#include "core/weld/process/gmaw.hpp"

#include "core/gl/state_archive.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/process/shielding_gas.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 2> kShortCircuits{"ordinary", "controlled"}; // as ShortCircuitKind
constexpr std::array<std::string_view, 3> kInductances{"low", "medium", "high"};
// Factors on the rate of the shorts; no source: chosen.
constexpr std::array<float, 3> kInductanceRates{1.4F, 1.0F, 0.7F};
constexpr float kMm = 1e-3F;
constexpr float kMetresPerMinute = 1.0F / 60;
constexpr float kPulled = 0.05F;     // pull that counts for a trigger that is a switch
constexpr float kFreeWay = 3;        // spacings of a drop's least fall: metal is not put into metal
constexpr float kLookBeyond = 0.03F; // m beyond the wire's end in which metal is looked for
/// m of wire that are straight at most; a longer wire hangs down and finds no metal on the axis. No source: chosen.
constexpr float kStraightWire = 0.06F;
/// Shorts a second of a wire that just touches; films show 20 to 200.
constexpr float kMostShorts = 120;
/// Shorts a second of a machine that controls them; such machines are said to make 40 to 130. No document was checked.
constexpr float kControlledShorts = 70;
/// Length of the arc, over the drop's diameter, beyond which no short circuit is left: exp(-6.25).
constexpr double kLongestDip = 2.5;
/// 1/s for an open arc that does not spray, see Equipment::spatter.
constexpr double kOpenSpatter = 45;
/// Drops finer than the wire leave the pool calm.
constexpr FreezingRipples kDipRipples{10, 1}, kSprayRipples{16, 0.5F};

constexpr std::array kRetired{
    RetiredSetting{"current", "the current follows from voltage and wire_feed_m_min"},
    kRetiredEfficiency,
    kRetiredSigma,
    RetiredSetting{"arc_length_mm", "the arc's length follows from voltage and wire_feed_m_min"},
    RetiredSetting{"drop_temperature_c", "the drops' temperature is a constant of the process"},
    RetiredSetting{"drop_speed", "the drops' speed is a constant of the process"},
};

bool isControlled(const GmawSettings& settings) {
    return static_cast<ShortCircuitKind>(settings.shortCircuits) == ShortCircuitKind::controlled;
}

const ShieldingGas& gasOf(const GmawSettings& settings) {
    return shieldingGas(static_cast<GasKind>(settings.gas));
}

/// Returns the ripples at the current that melts the wire as fast as it is fed.
FreezingRipples ripplesOf(const GmawSettings& settings) {
    const auto diameter = static_cast<double>(settings.wireDiameterMm);
    const double current = WireMelting::steel(diameter * 1e-3)
                               .current(static_cast<double>(settings.wireFeedMPerMin) / 60,
                                        static_cast<double>(settings.stickOutMm) * 1e-3);
    const auto sprays = static_cast<float>(sprayShare(current, diameter, gasOf(settings)));
    return {std::lerp(kDipRipples.frequency, kSprayRipples.frequency, sprays),
            std::lerp(kDipRipples.height, kSprayRipples.height, sprays)};
}

} // namespace

std::optional<ShortCircuitKind> findShortCircuits(std::string_view name) {
    const auto found = std::ranges::find(kShortCircuits, name);
    if (found == kShortCircuits.end()) return std::nullopt;
    return static_cast<ShortCircuitKind>(found - kShortCircuits.begin());
}

double sprayShare(double current, double diameterMm, const ShieldingGas& gas) {
    if (!gas.sprayCurrent) return 0;
    const double sprays = *gas.sprayCurrent * std::pow(diameterMm, kSprayExponent);
    return std::clamp((current / sprays - 1) / kSprayRange + 0.5, 0.0, 1.0);
}

double sprayHeatRadius(double current) {
    return kSprayRadius * std::pow(std::max(current, kLeastArcCurrent) / kSprayRadiusCurrent, kSprayRadiusExponent);
}

constinit const ProcessTraits Gmaw::kTraits{
    .name = kName,
    .arc = true,
    .feedsWire = true,
    .striking = Striking::wire,
    .shielding = Shielding::gas,
    .torch = TorchShape::wireTorch,
    .efficiency = 0.8,
    .fume = 1,
    .oxideIslands = true,
    // Rule of thumb for the gas: half a second; no document was checked.
    .sound = {.quiet = 0.020F, .loud = 0.110F, .lowPitch = 1100, .highPitch = 6000, .postFlow = 0.5},
    .retired = kRetired};

Equipment Gmaw::equipment(const GmawSettings& settings) {
    return {.wire = static_cast<double>(settings.wireDiameterMm) * 1e-3,
            .wireSpeed = static_cast<double>(settings.wireFeedMPerMin) * (1.0 / 60),
            .heldBehind = static_cast<double>(settings.stickOutMm) * 1e-3,
            .spatter = kOpenSpatter * gasOf(settings).spatter,
            .controlledShorts = isControlled(settings),
            .ripples = ripplesOf(settings),
            .displays = {{{settings.voltage, "v", 1}, {settings.wireFeedMPerMin, "m/min", 1}}},
            .gas = &gasOf(settings),
            .gasFlow = static_cast<double>(settings.gasFlowLMin)};
}

ParameterList describe(GmawSettings& s) {
    return {
        {"voltage", "Voltage", "V", &s.voltage, 5, 60, "A higher voltage makes the arc longer and the bead wider."},
        {"wire_feed_m_min", "Wire feed", "m/min", &s.wireFeedMPerMin, 0, 30, "More wire takes more current."},
        {"wire_diameter_mm", "Wire diameter", "mm", &s.wireDiameterMm, 0.5, 2.4, "Thicker wire takes more current."},
        {"short_circuits", "Short circuits", "", &s.shortCircuits, 0, 1,
         "Controlled: the machine ends each one without spatter, also at a low voltage.", kShortCircuits},
        {"inductance", "Inductance", "", &s.inductance, 0, 2,
         "A higher value makes fewer and softer shorts, if they are ordinary.", kInductances},
        {"stick_out_mm", "Stick-out", "mm", &s.stickOutMm, 3, 40,
         "Length of the wire at the start: tip-to-work distance less the arc."},
        {"gas", "Gas", "", &s.gas, 0, static_cast<double>(shieldingGasNames().size()) - 1,
         "Carbon dioxide needs more voltage, and no wire sprays in it.", shieldingGasNames()},
        {"gas_flow_l_min", "Gas flow", "l/min", &s.gasFlowLMin, 0, 30, "Too little lets air into the pool."},
    };
}

Gmaw::Gmaw(const ProcessMetal& metal) : Process(metal), wire_(static_cast<double>(settings_.stickOutMm * kMm)) {}

void Gmaw::apply(const ProcessSettings& settings) {
    const GmawSettings& wanted = settings.of<Gmaw>();
    const bool untouched = fed_ == 0;
    settings_ = wanted;
    if (untouched) wire_ = WireArc(static_cast<double>(settings_.stickOutMm * kMm));
}

void Gmaw::reset() {
    Process::reset();
    wire_ = WireArc(static_cast<double>(settings_.stickOutMm * kMm));
    fed_ = melted_ = 0;
}

void Gmaw::transfer(gl::StateArchive& archive) {
    Process::transfer(archive);
    wire_.transfer(archive);
    archive.values(fed_, melted_);
}

WireFeed Gmaw::feed() const {
    const double heat = metal_.table.liquidusEnthalpy() - metal_.table.enthalpyAt(metal_.ambient);
    return {static_cast<double>(settings_.voltage),
            static_cast<double>(settings_.wireFeedMPerMin * kMetresPerMinute),
            WireMelting::steel(static_cast<double>(settings_.wireDiameterMm * kMm)),
            wireArea() * metal_.density * heat / kGmawEfficiency,
            gasOf(settings_).arcVoltage,
            isControlled(settings_)};
}

/// Returns the stirring at the current that melts the wire as fast as it is fed.
double Gmaw::stirring() const {
    return arcStirring(settledCurrent());
}

/// Returns the current that melts the wire as fast as it is fed, at its stick-out.
double Gmaw::settledCurrent() const {
    const WireFeed fed = feed();
    return fed.melting.current(fed.speed, static_cast<double>(settings_.stickOutMm * kMm));
}

/// Returns the share of short circuits that an arc of `length` (m) and `current` (A) leaves, 0 to 1: exp(-1) of them if
/// it is as long as the drop that hangs on the wire is thick, none if it is much longer, or sprays.
double Gmaw::shortsLeft(double length, double current) const {
    const auto wire = static_cast<double>(settings_.wireDiameterMm);
    const double drops = length / (kGlobularDrop * wire * 1e-3);
    return drops > kLongestDip ? 0 : std::exp(-drops * drops) * (1 - sprayShare(current, wire, gasOf(settings_)));
}

/// Returns the share of short circuits that are left at the present settings.
double Gmaw::dipping() const {
    const double current = settledCurrent();
    return shortsLeft(openArcLength(feed(), current), current);
}

double Gmaw::dropTemperature() const {
    return std::lerp(kDropTemperature, kDipDropTemperature, dipping());
}

EdgeArrest Gmaw::edgeArrest() const {
    const EdgeArrest cold = Process::edgeArrest();
    const double time = arcTime(feed(), settledCurrent());
    const double full = std::clamp((time - kColdArcTime) / (kFullArcTime - kColdArcTime), 0.0, 1.0) * dipping();
    return {std::lerp(cold.coldAngle, kStefanAngle * std::numbers::pi / 180, full),
            std::lerp(cold.coldShare, kStefanColdShare, full), std::lerp(cold.warmShare, kStefanWarmShare, full)};
}

/// Returns the shorts (1/s) of a wire that just touches.
float Gmaw::mostShorts() const {
    if (isControlled(settings_)) return kControlledShorts;
    return kMostShorts * kInductanceRates[static_cast<size_t>(settings_.inductance)];
}

double Gmaw::wireArea() const {
    const auto diameter = static_cast<double>(settings_.wireDiameterMm * kMm);
    return std::numbers::pi / 4 * diameter * diameter;
}

WireAccount Gmaw::wire() const {
    return {fed_, melted_, wire_.extension(), wireArea(), metal_.density};
}

TorchRay Gmaw::ray(const TorchSample& torch) const {
    const glm::vec3 axis = torch.axis();
    return {torch.tip - axis * (settings_.stickOutMm * kMm), axis,
            std::clamp(static_cast<float>(wire_.extension()), settings_.stickOutMm * kMm, kStraightWire) + kLookBeyond};
}

void Gmaw::advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) {
    const WireFeed fed = feed();
    if (torch.trigger < kPulled || fed.speed <= 0) {
        wire_.release();
        arc_.noArc = torch.trigger < kPulled ? NoArc::released : NoArc::noWire;
        arc_.extension = static_cast<float>(wire_.extension());
        return;
    }
    wire_.step(fed, static_cast<double>(ahead.distance), seconds);
    fed_ += wire_.fed();
    melted_ += wire_.melted();
    takeOver();
    if (arc_.burns() && wire_.fed() > 0) transferHeat(torch, seconds);
}

/// Copies the circuit's values into the arc's state.
void Gmaw::takeOver() {
    arc_.action = wire_.action();
    arc_.noArc = wire_.noArc();
    arc_.extension = static_cast<float>(wire_.extension());
    arc_.length = static_cast<float>(wire_.length());
    arc_.current = static_cast<float>(wire_.current());
    arc_.voltage = static_cast<float>(wire_.voltage());
    arc_.stretch = static_cast<float>(wire_.stretch());
    arc_.share = arc_.burns() ? 1.0F : 0.0F;
    if (!arc_.burns()) return;
    // A wire that touches has them at any current; above that of spray its arc is buried, and its drops are hot.
    const double left = arc_.action == ArcAction::shorting ? 1 : shortsLeft(wire_.length(), wire_.current());
    arc_.shorts = mostShorts() * static_cast<float>(left);
}

/// Efficiency times U I goes into the metal: a part with the drops, the rest onto the surface. In spray the arc
/// envelops the wire's end, and its width no longer follows its length.
void Gmaw::transferHeat(const TorchSample& torch, double seconds) {
    const auto current = static_cast<double>(arc_.current);
    const double narrow = arcHeatRadius(wire_.length(), current);
    const double sprays = sprayShare(current, static_cast<double>(settings_.wireDiameterMm), gasOf(settings_));
    arc_.radius = static_cast<float>(std::lerp(narrow, sprayHeatRadius(current), sprays));
    pressSurface(current, std::lerp(narrow, kSprayPressureRadius, sprays));
    arc_.power = kGmawEfficiency * static_cast<double>(arc_.voltage) * current;
    const TorchRay from = ray(torch);
    const float end = std::max(std::min(arc_.extension, arc_.distance - kFreeWay * metal_.spacing), 0.0F);
    const double brought =
        meltWire(wire_.melted() * wireArea(), seconds, from.origin + from.axis * end,
                 from.axis * std::lerp(kDropSpeed, kSprayDropSpeed, static_cast<float>(sprays)), arc_.power);
    heatSurface(from, arc_.power - brought);
}

} // namespace meltpool
