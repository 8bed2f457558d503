#include "core/training/judging/estimates.hpp"

#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/weld/process/shielding_gas.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace meltpool {

namespace {

using enum TechniqueQuantity;

constexpr double kLoadLineVoltage = 14; ///< V
constexpr double kLoadLineSlope = 0.05; ///< V/A
constexpr double kPerMetre = 1e3;       ///< mm

/// One reason to expect an imperfection.
struct Rule {
    std::string_view name; ///< part of the keys of its sentences
    std::function<bool(const SeamMillimetre&)> holds;
    std::string_view limitName = {}; ///< named place for its limit in those sentences; empty: its limits are constants
    double limit = 0;                ///< limit as in the sentence, mm, mm/s or L/min
};

std::string number(double value) {
    return withDecimalMark(formatNumber(std::round(value * 100) / 100));
}

Rule tooFar() {
    return {"tip_far", [](const SeamMillimetre& mm) { return mm.values[distance] > kGasCoverDistance; }, "distance",
            kGasCoverDistance * kPerMetre};
}

Rule tooFlat() {
    return {"torch_flat", [](const SeamMillimetre& mm) {
                const double angle = mm.values[travelAngle] * 180 / std::numbers::pi;
                return angle > kMostPush || angle < -kMostDrag;
            }};
}

/// An arc longer than `most` (m).
Rule tooLong(double most, std::string_view name) {
    return {name, [most](const SeamMillimetre& mm) { return mm.values[distance] > most; }, "arc", most * kPerMetre};
}

/// Returns the voltage above the gas's balance, V. `gasVoltage`: see ShieldingGas::arcVoltage.
double excessVoltage(const SeamMillimetre& mm, double gasVoltage) {
    return mm.voltage - gasVoltage - (kLoadLineVoltage + kLoadLineSlope * mm.current);
}

Rule outOfBalance(double gasVoltage) {
    return {"out_of_balance", [gasVoltage](const SeamMillimetre& mm) {
                const double excess = excessVoltage(mm, gasVoltage);
                return excess > kBalanceAbove || excess < -kBalanceBelow;
            }};
}

/// The rule for a machine that controls its short circuits: a low voltage does no harm.
Rule overBalance(double gasVoltage) {
    return {"over_balance",
            [gasVoltage](const SeamMillimetre& mm) { return excessVoltage(mm, gasVoltage) > kBalanceAbove; }};
}

/// An arc that stays open in a gas in which no wire sprays.
Rule largeDrops(double gasVoltage) {
    return {"large_drops", [gasVoltage](const SeamMillimetre& mm) {
                return mm.voltage > kArcFallVoltage + gasVoltage + kWireResistance * mm.current;
            }};
}

bool always(const SeamMillimetre& /*mm*/) {
    return true;
}

/// Returns the rule for a machine whose gas does not cover the pool anywhere; none if it does.
std::optional<Rule> uncovered(const Equipment& tools) {
    if (tools.withoutGas()) return {{"no_gas", always}};
    const double least = kLeastGasShare * kGasFlowPerMm * tools.wire * kPerMetre; // L/min
    if (tools.wire > 0 && tools.gasFlow < least) return {{"little_gas", always, "flow", least}};
    return std::nullopt;
}

std::vector<Rule> poreRules(const ProcessTraits& traits, const Equipment& tools) {
    const double core = tools.electrode;
    switch (traits.shielding) {
    case Shielding::gas:
        if (auto rule = uncovered(tools)) return {*std::move(rule)};
        if (traits.distance == DistanceKind::ctwd) return {tooFar(), tooFlat()};
        return {tooLong(kGasCoverArc, "arc_long"), tooFlat()};
    case Shielding::slag:
        return {tooLong(kUncoveredArc * core, "arc_uncovered")};
    case Shielding::none:
        break;
    }
    return {};
}

std::vector<Rule> spatterRules(const ProcessTraits& traits, const Equipment& tools) {
    const double core = tools.electrode, gasVoltage = tools.gas == nullptr ? 0 : tools.gas->arcVoltage;
    const Rule balance = tools.controlledShorts ? overBalance(gasVoltage) : outOfBalance(gasVoltage);
    if (traits.feedsWire && tools.gas != nullptr && !tools.gas->sprayCurrent) return {balance, largeDrops(gasVoltage)};
    if (traits.feedsWire) return {balance};
    if (traits.shielding != Shielding::slag) return {};
    return {tooLong(kSpatteringArc * core, "arc_spatters")};
}

std::vector<Rule> slagRules(const ProcessTraits& traits, std::optional<double> askedSpeed) {
    if (traits.shielding != Shielding::slag) return {};
    std::vector<Rule> rules{{"electrode_pushes", [](const SeamMillimetre& mm) { return mm.values[travelAngle] > 0; }}};
    if (!askedSpeed) return rules;
    const double least = kSlagOvertakes * *askedSpeed;
    rules.push_back({"travels_slowly", [least](const SeamMillimetre& mm) { return mm.values[travelSpeed] < least; },
                     "speed", least * kPerMetre});
    return rules;
}

/// An estimate by one or two rules: the millimetres that meet any of them. The sentence names the rules that some
/// millimetre meets, or all of them if no millimetre meets any.
Estimate estimate(std::string name, std::span<const SeamMillimetre> seam, std::span<const Rule> rules) {
    Estimate made{std::move(name), 0, {}};
    const auto count = [&](const auto& holds) {
        return static_cast<double>(std::count_if(seam.begin(), seam.end(), holds));
    };
    made.value = count([&](const SeamMillimetre& mm) {
        return std::any_of(rules.begin(), rules.end(), [&](const Rule& rule) { return rule.holds(mm); });
    });
    std::string key = made.value > 0 ? "estimate.expected." : "estimate.not_expected.";
    std::vector<double> lengths; // lengths of the named rules
    for (const Rule& rule : rules) {
        const double length = count(rule.holds);
        if (made.value > 0 && length == 0) continue;
        key += lengths.empty() ? "" : "_or_";
        key += rule.name;
        lengths.push_back(length);
    }
    made.rule = phrase(key, {{"length", number(lengths.front())},
                             {"second_length", number(lengths.back())},
                             {rules.front().limitName, number(rules.front().limit)},
                             {rules.back().limitName, number(rules.back().limit)},
                             {"push", number(kMostPush)},
                             {"drag", number(kMostDrag)},
                             {"above", number(kBalanceAbove)},
                             {"below", number(kBalanceBelow)}});
    return made;
}

} // namespace

std::vector<Estimate> estimateImperfections(std::span<const SeamMillimetre> seam, const ProcessSettings& process,
                                            std::optional<double> askedSpeed) {
    const ProcessTraits& traits = traitsOf(process);
    const Equipment tools = equipmentOf(process);
    std::vector<Estimate> estimates;
    if (seam.empty() || !traits.arc) return estimates;
    const auto add = [&](const char* name, std::span<const Rule> rules) {
        if (!rules.empty()) estimates.push_back(estimate(name, seam, rules));
    };
    add("surface_pore", poreRules(traits, tools));
    add("spatter", spatterRules(traits, tools));
    add("slag_inclusion", slagRules(traits, askedSpeed));
    return estimates;
}

} // namespace meltpool
