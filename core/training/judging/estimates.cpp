#include "core/training/judging/estimates.hpp"

#include "core/base/text.hpp"

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
    std::string when; ///< "the contact tip is over 18 mm from the work (a public scoring table)"
    std::function<bool(const SeamMillimetre&)> holds;
};

std::string number(double value) {
    return formatNumber(std::round(value * 100) / 100);
}

Rule tooFar() {
    return {"the contact tip is over " + number(kGasCoverDistance * kPerMetre) +
                " mm from the work (a scoring table for GMAW trainers)",
            [](const SeamMillimetre& mm) { return mm.values[distance] > kGasCoverDistance; }};
}

Rule tooFlat() {
    return {"the torch pushes by over " + number(kMostPush) + "\xC2\xB0 or drags by over " + number(kMostDrag) +
                "\xC2\xB0 (angles of a scoring table; that they draw air in is trade knowledge)",
            [](const SeamMillimetre& mm) {
                const double angle = mm.values[travelAngle] * 180 / std::numbers::pi;
                return angle > kMostPush || angle < -kMostDrag;
            }};
}

/// An arc longer than `most` (m).
Rule tooLong(double most, const std::string& source) {
    return {"the arc is over " + number(most * kPerMetre) + " mm long (" + source + ")",
            [most](const SeamMillimetre& mm) { return mm.values[distance] > most; }};
}

Rule outOfBalance() {
    return {"the voltage is over " + number(kBalanceAbove) + " V above or " + number(kBalanceBelow) +
                " V below 14 V + 0.05 V/A (published settings and 3 V, which this program chose)",
            [](const SeamMillimetre& mm) {
                const double excess = mm.voltage - (kLoadLineVoltage + kLoadLineSlope * mm.current);
                return excess > kBalanceAbove || excess < -kBalanceBelow;
            }};
}

/// `core`: m, diameter of a covered electrode.
std::vector<Rule> poreRules(const ProcessTraits& traits, double core) {
    switch (traits.shielding) {
    case Shielding::gas:
        if (traits.distance == DistanceKind::ctwd) return {tooFar(), tooFlat()};
        return {tooLong(kGasCoverArc, "this program's choice"), tooFlat()};
    case Shielding::slag:
        return {tooLong(kUncoveredArc * core, "twice the core, this program's choice")};
    case Shielding::none:
        break;
    }
    return {};
}

std::vector<Rule> spatterRules(const ProcessTraits& traits, double core) {
    if (traits.feedsWire) return {outOfBalance()};
    if (traits.shielding != Shielding::slag) return {};
    return {tooLong(kSpatteringArc * core,
                    "a maker asks for at most the core's diameter; the half more is this program's choice")};
}

std::vector<Rule> slagRules(const ProcessTraits& traits, std::optional<double> askedSpeed) {
    if (traits.shielding != Shielding::slag) return {};
    std::vector<Rule> rules{{"the electrode pushes, so that slag runs before the pool (trade knowledge)",
                             [](const SeamMillimetre& mm) { return mm.values[travelAngle] > 0; }}};
    if (!askedSpeed) return rules;
    const double least = kSlagOvertakes * *askedSpeed;
    rules.push_back({"the arc travels below " + number(least * kPerMetre) +
                         " mm/s, half of what is asked for (this program's choice)",
                     [least](const SeamMillimetre& mm) { return mm.values[travelSpeed] < least; }});
    return rules;
}

/// The millimetres that meet any of the rules, told with those rules that some meet; with all of them where none does.
Estimate estimate(std::string name, std::span<const SeamMillimetre> seam, std::span<const Rule> rules) {
    Estimate made{std::move(name), 0, {}};
    const auto count = [&](const auto& holds) {
        return static_cast<double>(std::count_if(seam.begin(), seam.end(), holds));
    };
    made.value = count([&](const SeamMillimetre& mm) {
        return std::any_of(rules.begin(), rules.end(), [&](const Rule& rule) { return rule.holds(mm); });
    });
    made.rule = made.value > 0 ? "To be expected where " : "It would be expected where ";
    bool first = true;
    for (const Rule& rule : rules) {
        const double length = count(rule.holds);
        if (made.value > 0 && length == 0) continue;
        made.rule += (first ? "" : ", or ") + rule.when;
        if (length > 0) made.rule += ": " + number(length) + " mm";
        first = false;
    }
    made.rule += ".";
    return made;
}

} // namespace

std::vector<Estimate> estimateImperfections(std::span<const SeamMillimetre> seam, const ProcessSettings& process,
                                            std::optional<double> askedSpeed) {
    const ProcessTraits& traits = traitsOf(process);
    const double core = equipmentOf(process).electrode;
    std::vector<Estimate> estimates;
    if (seam.empty() || !traits.arc) return estimates;
    const auto add = [&](const char* name, std::span<const Rule> rules) {
        if (!rules.empty()) estimates.push_back(estimate(name, seam, rules));
    };
    add("surface_pore", poreRules(traits, core));
    add("spatter", spatterRules(traits, core));
    add("slag_inclusion", slagRules(traits, askedSpeed));
    return estimates;
}

} // namespace meltpool
