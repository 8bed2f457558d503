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

std::vector<Rule> poreRules(const ProcessSettings& process) {
    if (process.is<Gmaw>()) return {tooFar(), tooFlat()};
    if (process.is<Gtaw>()) return {tooLong(kGasCoverArc, "this program's choice"), tooFlat()};
    const double core = static_cast<double>(process.of<Smaw>().diameterMm) / kPerMetre;
    return {tooLong(kUncoveredArc * core, "twice the core, this program's choice")};
}

std::vector<Rule> spatterRules(const ProcessSettings& process) {
    if (process.is<Gmaw>()) return {outOfBalance()};
    if (!process.is<Smaw>()) return {};
    const double core = static_cast<double>(process.of<Smaw>().diameterMm) / kPerMetre;
    return {tooLong(kSpatteringArc * core, "a maker asks for at most the core's diameter; the half more is this "
                                           "program's choice")};
}

std::vector<Rule> slagRules(const ProcessSettings& process, std::optional<double> askedSpeed) {
    if (!process.is<Smaw>()) return {};
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
    std::vector<Estimate> estimates;
    if (seam.empty() || !isArcWelding(process)) return estimates;
    estimates.push_back(estimate("surface_pore", seam, poreRules(process)));
    if (const auto rules = spatterRules(process); !rules.empty()) estimates.push_back(estimate("spatter", seam, rules));
    if (const auto rules = slagRules(process, askedSpeed); !rules.empty())
        estimates.push_back(estimate("slag_inclusion", seam, rules));
    return estimates;
}

} // namespace meltpool
