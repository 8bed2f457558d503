#include "core/validation/torch_run.hpp"

#include "core/base/error.hpp"
#include "core/weld/process/shielding_gas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;
constexpr double kArcOfPower = 3e-3; // m, length of an arc that is given by its power alone

/// Returns the height (m) of the metal under the arc above the corner that the wire of a fillet points at: the throat
/// of a flat face is the root of its section, and the pool under the arc has filled this share of it. By the current
/// that the fillets PANF-4 and OTCH-9 of tests/validation/vendor drew with a feed that did not include it.
double filledUnderArc(double section) {
    constexpr double kFilledThroat = 0.67;
    return kFilledThroat * std::sqrt(section);
}

/// Returns the feed (m/s) that melts at `current` on this machine.
double feedAt(const ValidationCase& from, const WireFeed& feed, double current) {
    const double ctwd = from.number("ctwd_mm") * 1e-3;
    const auto melting = [&](double filled) { return feedAtCurrent(feed, ctwd - filled, current); };
    const std::string_view kind = from.kind->name;
    if (kind != "fillet" && kind != "chart_tee" && kind != "chart_lap") return melting(0);
    const double radius = from.number("wire_diameter_mm") * 0.5e-3;
    const double wire = std::numbers::pi * radius * radius, travel = from.number("speed_mm_s") * 1e-3;
    double speed = melting(0);
    for (int i = 0; i < 30; ++i) // more feed leaves less wire that melts, so this closes in
        speed = 0.5 * (speed + melting(filledUnderArc(speed * wire / travel)));
    return speed;
}

/// Returns the voltage (V) for `power` (W) with this feed: power over the current, which itself depends little on the
/// voltage.
double voltageOfPower(WireFeed feed, double ctwd, double power) {
    feed.voltage = 20;
    for (int i = 0; i < 20; ++i) {
        const double current = feed.melting.current(feed.speed, 0.8 * ctwd);
        feed.voltage = power / std::max(current, 1.0);
    }
    return feed.voltage;
}

void setWire(const ValidationCase& from, GmawSettings& gmaw) {
    const double diameter = from.number("wire_diameter_mm") * 1e-3;
    const double ctwd = from.number("ctwd_mm") * 1e-3;
    WireFeed feed{from.number("voltage"), from.number("wire_feed_m_min") / 60, WireMelting::steel(diameter)};
    if (const ShieldingGas* gas = findShieldingGas(from.word("gas"))) {
        feed.gasVoltage = gas->arcVoltage;
        gmaw.gas = static_cast<int>(gas - shieldingGases().data());
    }
    if (const auto kind = findShortCircuits(from.word("short_circuits"))) gmaw.shortCircuits = static_cast<int>(*kind);
    if (feed.voltage <= 0 && from.number("power_w") > 0 && from.number("current_a") > 0)
        feed.voltage = from.number("power_w") / from.number("current_a");
    if (feed.speed <= 0) feed.speed = feedAt(from, feed, from.number("current_a"));
    if (feed.voltage <= 0) feed.voltage = voltageOfPower(feed, ctwd, from.number("power_w"));
    if (const auto offset = from.numbers.find("voltage_offset_v"); offset != from.numbers.end())
        feed.voltage += offset->second;
    gmaw.voltage = static_cast<float>(feed.voltage);
    gmaw.wireFeedMPerMin = static_cast<float>(feed.speed * 60);
    gmaw.wireDiameterMm = static_cast<float>(diameter * 1e3);
    // The wire reaches nearly to the plate, so that the arc strikes at once.
    gmaw.stickOutMm = std::max(static_cast<float>(ctwd * 1e3) - 1, 0.5F * static_cast<float>(ctwd * 1e3));
}

/// Returns the current (A) of an argon arc whose voltage times current is `power`: U = a + b I.
double currentOfPower(double power) {
    const double base = gtawVoltage(kArcOfPower, 0), slope = gtawVoltage(kArcOfPower, 1) - base;
    return (std::sqrt(base * base + 4 * slope * power) - base) / (2 * slope);
}

void setTungsten(const ValidationCase& from, GtawSettings& gtaw) {
    const double current = from.number("current_a");
    gtaw.current = static_cast<float>(current > 0 ? current : currentOfPower(from.number("power_w")));
    if (const double diameter = numberOrNone(from, "electrode_diameter_mm"); diameter > 0)
        gtaw.electrodeDiameterMm = static_cast<float>(diameter);
    if (const double rod = numberOrNone(from, "rod_diameter_mm"); rod > 0) gtaw.rodDiameterMm = static_cast<float>(rod);
}

void setElectrode(const ValidationCase& from, SmawSettings& smaw) {
    const auto names = smawElectrodes();
    smaw.current = static_cast<float>(from.number("current_a"));
    smaw.electrode = static_cast<int>(std::find(names.begin(), names.end(), from.word("electrode")) - names.begin());
    smaw.diameterMm = static_cast<float>(from.number("electrode_diameter_mm"));
}

} // namespace

double numberOrNone(const ValidationCase& from, std::string_view key) {
    const auto found = from.numbers.find(key);
    return found == from.numbers.end() ? 0 : found->second;
}

double caseBurnOff(const ValidationCase& from, const ProcessSettings& process) {
    if (from.process != Smaw::kName) return 0;
    const SmawSettings& smaw = process.of<Smaw>();
    return smawBurnOff(smaw.electrode, static_cast<double>(smaw.current), static_cast<double>(smaw.diameterMm) * 1e-3);
}

double caseFillerRate(const ValidationCase& from, const ProcessSettings& process) {
    const double wire = equipmentOf(process).wireRate(), burnOff = caseBurnOff(from, process);
    if (wire > 0) return wire;
    const double speed = burnOff > 0 ? burnOff : numberOrNone(from, "rod_feed_mm_s") * 1e-3;
    const double diameter = numberOrNone(from, burnOff > 0 ? "electrode_diameter_mm" : "rod_diameter_mm") * 1e-3;
    return std::numbers::pi / 4 * diameter * diameter * speed;
}

ProcessSettings caseProcess(const ValidationCase& from) {
    ProcessSettings settings;
    if (hasWire(from)) {
        setWire(from, settings.choose<Gmaw>());
    } else if (from.process == Smaw::kName) {
        setElectrode(from, settings.choose<Smaw>());
    } else {
        setTungsten(from, settings.choose<Gtaw>());
    }
    return settings;
}

float caseTorchHeight(const ValidationCase& from, const ProcessSettings& settings) {
    if (!hasWire(from)) return static_cast<float>(from.number("arc_length_mm")) * kMm;
    return static_cast<float>(from.number("ctwd_mm")) * kMm - settings.of<Gmaw>().stickOutMm * kMm;
}

TorchPath straightRun(float start, float end, float height, double seconds) {
    TorchMove run;
    run.duration = seconds;
    run.from = {start, height, 0};
    run.to = {end, height, 0};
    run.fromOrientation = run.toOrientation = heldOrientation(std::numbers::pi / 2, 0, {1, 0, 0});
    run.trigger = 1;
    return TorchPath(std::vector{run});
}

TorchPath heldRun(float start, float end, const TorchPose& held, double seconds) {
    TorchMove run;
    run.duration = seconds;
    run.fromOrientation = run.toOrientation = heldOrientation(held.workAngle, held.travelAngle, {1, 0, 0});
    const glm::vec3 back = run.fromOrientation * glm::vec3(0, 0, 1) * held.height;
    run.from = glm::vec3(start, 0, 0) + back;
    run.to = glm::vec3(end, 0, 0) + back;
    run.trigger = 1;
    return TorchPath(std::vector{run});
}

float wholeSpacings(double length, float spacing) {
    return std::max(std::round(static_cast<float>(length) / spacing), 1.0F) * spacing;
}

Workpiece casePlate(const ValidationCase& from, float length, float thickness, float width, double temperature) {
    WorkpieceParameters plate;
    plate.kind = static_cast<int>(WorkpieceKind::Plate);
    plate.spacingMm = static_cast<float>(from.spacing * 1e3);
    const auto whole = [&](float metres) { return wholeSpacings(static_cast<double>(metres * 1e3F), plate.spacingMm); };
    plate.lengthMm = whole(length);
    plate.thicknessMm = whole(thickness);
    plate.widthMm = whole(width / 2) * 2;
    plate.temperatureC = static_cast<float>(temperature - 273.15);
    return makeWorkpiece(plate);
}

} // namespace meltpool
