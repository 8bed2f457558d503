#include "core/weld/process/smaw.hpp"

#include "core/gl/state_archive.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
// Pull that counts for a trigger that is a switch: the holder is live.
constexpr float kPulled = 0.05F;
constexpr float kLookBefore = 0.01F;               // m before the electrode's end from which its metal is looked for
constexpr float kLookBeyond = 0.03F;               // m beyond the electrode's end
constexpr double kTouch = 0.25e-3;                 // m: accuracy with which the surface is known
constexpr float kFreeWay = 3;                      // spacings of a drop's least fall: metal is not put into metal
constexpr double kSteelDensity = 7850;             // kg/m³ of the core
constexpr double kGramPerAmpereHour = 1e-3 / 3600; // kg/(A s)

/// 1/s, see Equipment::spatter: the covering's gas tears the drops.
constexpr double kSpatter = 90;
/// Drops are large, and slag covers the tail.
constexpr FreezingRipples kRipples{7, 1.5F};

/// Falls at the arc's ends (V), burn-off (g/(A h)) and spatter (times kSpatter; a cellulosic covering gives the most
/// gas). Trade knowledge; no document was checked.
struct Electrode {
    std::string_view name;
    double fall = 0;
    double burnOff = 0;
    double spatter = 1;
};
constexpr std::array<Electrode, 3> kElectrodes{{{"e6013", 16, 9.0, 1}, {"e7018", 17, 8.5, 1}, {"e6010", 21, 9.5, 2}}};
constexpr std::array<std::string_view, 3> kNames{kElectrodes[0].name, kElectrodes[1].name, kElectrodes[2].name};

const Electrode& electrodeOf(int electrode) {
    return kElectrodes[static_cast<size_t>(std::clamp(electrode, 0, int(kElectrodes.size()) - 1))];
}

double loadLine(double current) {
    return kSmawLoadVoltage + kSmawLoadSlope * current;
}

/// Returns the angle (rad) between two orientations.
double turnBetween(const glm::quat& a, const glm::quat& b) {
    return 2 * std::acos(std::min(std::abs(static_cast<double>(glm::dot(a, b))), 1.0));
}

} // namespace

constinit const ProcessTraits Smaw::kTraits{
    .name = kName,
    .arc = true,
    .distance = DistanceKind::arcLength,
    .striking = Striking::touch,
    .shielding = Shielding::slag,
    .torch = TorchShape::electrodeHolder,
    .efficiency = 0.8,
    .fume = 1.5F,
    .sound = {
        .quiet = 0.020F, .loud = 0.080F, .lowPitch = 900, .highPitch = 4000, .crackles = true, .scratches = true}};

Equipment Smaw::equipment(const SmawSettings& settings) {
    return {.electrode = static_cast<double>(settings.diameterMm) * kMm,
            .electrodeName = kNames[static_cast<size_t>(settings.electrode)],
            .electrodeLength = static_cast<double>(settings.lengthMm) * kMm,
            .spatter = kSpatter * electrodeOf(settings.electrode).spatter,
            .ripples = kRipples,
            .displays = {{{settings.current, "a"}}}};
}

std::span<const std::string_view> smawElectrodes() {
    return kNames;
}

ParameterList describe(SmawSettings& s) {
    return {
        {"current", "Current", "A", &s.current, 20, 400, "The machine holds it. More current melts deeper and faster."},
        {"electrode", "Electrode", "", &s.electrode, 0, 2,
         "Rutile, basic or cellulosic. You get a new one when it is used up.", kNames},
        {"electrode_diameter_mm", "Core diameter", "mm", &s.diameterMm, 1.6, 6, "A thicker one takes more current."},
        {"electrode_length_mm", "Electrode length", "mm", &s.lengthMm, 100, 450, "Length of a new one, with its stub."},
    };
}

double smawVoltage(int electrode, double length, double current) {
    return electrodeOf(electrode).fall + kSmawField * std::max(length, 0.0) + kSmawResistance * current;
}

double smawLongestArc(int electrode, double current) {
    return std::max(kSmawReserve * loadLine(current) - smawVoltage(electrode, 0, current), 0.0) / kSmawField;
}

double smawBurnOff(int electrode, double current, double diameter) {
    const double area = std::numbers::pi / 4 * diameter * diameter;
    return electrodeOf(electrode).burnOff * kGramPerAmpereHour * std::max(current, 0.0) / (kSteelDensity * area);
}

void Smaw::apply(const ProcessSettings& settings) {
    settings_ = settings.of<Smaw>();
}

double Smaw::stirring() const {
    return arcStirring(static_cast<double>(settings_.current));
}

double Smaw::area() const {
    const double diameter = static_cast<double>(settings_.diameterMm) * kMm;
    return std::numbers::pi / 4 * diameter * diameter;
}

/// Returns the length of electrode out of the holder, m.
double Smaw::standing() const {
    return static_cast<double>(settings_.lengthMm) * kMm - burnt_;
}

WireAccount Smaw::wire() const {
    return {melted_, melted_, 0, area(), kSteelDensity};
}

void Smaw::reset() {
    Process::reset();
    noArc_ = NoArc::released;
    touched_ = live_ = false;
    touching_ = burnt_ = melted_ = 0;
}

TorchRay Smaw::ray(const TorchSample& torch) const {
    const glm::vec3 axis = torch.axis();
    return {torch.tip - axis * (static_cast<float>(burnt_) + kLookBefore), axis, kLookBefore + kLookBeyond};
}

void Smaw::transfer(gl::StateArchive& archive) {
    Process::transfer(archive);
    archive.values(noArc_, touched_, live_, touching_, held_, burnt_, melted_);
}

/// Handles a released trigger: the holder is dead, and a burnt electrode is replaced.
void Smaw::takeAway() {
    if (standing() <= kSmawStub) burnt_ = 0;
    noArc_ = NoArc::released;
    touched_ = live_ = false;
    touching_ = 0;
}

/// Handles an electrode that touches the metal: it may strike when it is lifted, and sticks otherwise.
NoArc Smaw::touch(const TorchSample& torch, double seconds) {
    touching_ = touched_ ? touching_ + seconds : 0;
    touched_ = live_ = true;
    if (touching_ < kSmawSticks) return noArc_ == NoArc::burns ? NoArc::burns : NoArc::touching;
    held_ = torch.orientation;
    return NoArc::stuck;
}

/// Returns the reason why this step has no arc, the holder live. `length`: m from the electrode's end to the metal.
NoArc Smaw::whyNot(const TorchSample& torch, double length, double seconds) {
    if (noArc_ == NoArc::stuck) {
        if (turnBetween(held_, torch.orientation) < kSmawFrees && length < kSmawTears) return NoArc::stuck;
        touching_ = 0;
        live_ = false; // the arc must be struck again
    }
    if (standing() <= kSmawStub) return NoArc::usedUp;
    const bool lit = noArc_ == NoArc::burns;
    if (length <= kTouch) return touch(torch, seconds);
    touched_ = false;
    if (!std::isfinite(length)) {
        live_ = false;
        return lit ? NoArc::metalLeft : wentOut(noArc_) && noArc_ != NoArc::stuck ? noArc_ : NoArc::noMetal;
    }
    if (lit && length <= smawLongestArc(settings_.electrode, static_cast<double>(settings_.current)))
        return NoArc::burns;
    if (live_ && length <= kSmawLift) return NoArc::burns;
    live_ = false;
    if (lit) return NoArc::tooLong;
    return wentOut(noArc_) && noArc_ != NoArc::stuck ? noArc_ : NoArc::tooFar;
}

void Smaw::advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) {
    const double length = static_cast<double>(ahead.distance) - static_cast<double>(kLookBefore);
    arc_.distance = std::max(ahead.distance - kLookBefore, 0.0F);
    arc_.extension = static_cast<float>(standing());
    if (torch.trigger < kPulled) {
        takeAway();
        arc_.noArc = NoArc::released;
        return;
    }
    const bool strikes = noArc_ != NoArc::burns;
    arc_.noArc = noArc_ = whyNot(torch, length, seconds);
    if (noArc_ != NoArc::burns) return;
    burn(std::max(length, 0.0));
    if (strikes) arc_.action = ArcAction::striking;
    melt(torch, static_cast<double>(ahead.distance), seconds);
}

/// Solves the circuit with an arc of `length` m, or with the electrode's end in the pool.
void Smaw::burn(double length) {
    const auto set = static_cast<double>(settings_.current);
    const double voltage = touched_ ? kSmawTouchVoltage : smawVoltage(settings_.electrode, length, set);
    const double current = touched_ ? kSmawTouchCurrent * set : set;
    const double breaking = loadLine(set);
    arc_.action = touched_ ? ArcAction::shorting : voltage > breaking ? ArcAction::breaking : ArcAction::burning;
    arc_.length = touched_ ? 0.0F : static_cast<float>(length);
    arc_.current = static_cast<float>(current);
    arc_.voltage = static_cast<float>(voltage);
    arc_.power = kSmawEfficiency * voltage * current;
    arc_.radius = static_cast<float>(arcHeatRadius(length, current));
    if (!touched_) pressSurface(current, static_cast<double>(arc_.radius));
    arc_.share = 1;
    // A welder holds an arc as long as the core is thick.
    const double atRest = smawVoltage(settings_.electrode, static_cast<double>(settings_.diameterMm) * kMm, set);
    arc_.stretch = static_cast<float>(std::clamp((voltage - atRest) / std::max(breaking - atRest, 0.1), 0.0, 1.0));
}

/// An end that touches melts no faster than its power allows: meltWire() makes its drops colder.
void Smaw::melt(const TorchSample& torch, double distance, double seconds) {
    const double diameter = static_cast<double>(settings_.diameterMm) * kMm;
    const double length =
        std::min(smawBurnOff(settings_.electrode, static_cast<double>(arc_.current), diameter) * seconds,
                 std::max(standing() - kSmawStub, 0.0));
    const TorchRay from = ray(torch);
    burnt_ += length;
    melted_ += length;
    const double free = distance - static_cast<double>(kFreeWay * metal_.spacing);
    const auto fall = static_cast<float>(std::clamp(free, 0.0, static_cast<double>(kLookBefore)));
    const double brought = meltWire(kSmawDeposit * length * area(), seconds, from.origin + from.axis * fall,
                                    from.axis * kDropSpeed, arc_.power);
    heatSurface({from.origin + from.axis * kLookBefore, from.axis}, arc_.power - brought);
}

} // namespace meltpool
