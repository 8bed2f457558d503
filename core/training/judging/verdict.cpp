#include "core/training/judging/verdict.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kPerMetre = 1e3;  ///< mm
constexpr double kRounding = 1e-6; ///< mm, rounding of sums of pitches
constexpr double kEqual = 1e-6;    ///< relative difference of equal sizes in single precision
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// One station measured against one limit.
struct Look {
    VerdictState state = VerdictState::notResolved;
    double value = 0, limit = 0, excess = 0, resolution = 0; ///< values in the imperfection's unit
    double place = 0;                                        ///< m
};

int severity(VerdictState state) {
    if (state == VerdictState::fail) return 2;
    return state == VerdictState::pass ? 0 : 1;
}

bool worse(const Look& a, const Look& b) {
    if (severity(a.state) != severity(b.state)) return severity(a.state) > severity(b.state);
    return a.excess > b.excess;
}

VerdictState stateOf(double excess, double limit, double resolution, bool isAngle) {
    if (!std::isfinite(limit)) return VerdictState::notResolved;
    const bool fine = isAngle || limit < resolution * (1 - kEqual);
    const double slack = fine ? resolution : 0;
    if (excess > slack) return VerdictState::fail;
    return excess <= -slack ? VerdictState::pass : VerdictState::notResolved;
}

/// Judges one item over all stations.
class ItemJudge {
  public:
    ItemJudge(const WeldMeasures& measures, const AcceptanceItem& item, const WeldFigure& imperfection,
              const NominalWeld& nominal)
        : measures_(measures),
          item_(item),
          nominal_(nominal),
          what_(imperfection),
          resolution_(resolvedOf(what_, measures.spacing)),
          sizes_{kUnknown, nominal.throatOf(measures.kind).value_or(kUnknown) * kPerMetre,
                 nominal.thickness * kPerMetre, nominal.legOf().value_or(kUnknown) * kPerMetre} {}

    /// Empty if the item does not apply to this weld.
    std::optional<VerdictItem> judge() const;
    /// Judges an estimate by the item.
    VerdictItem judgeEstimate(const Estimate& estimate) const;

  private:
    std::vector<PlacedImperfection> found() const;
    Look look(const PlacedImperfection& told, const LimitFormula& formula) const;
    VerdictItem blank() const;
    VerdictItem made(const Look& look, VerdictState state) const;
    VerdictItem decide(const std::vector<Look>& looks, const std::vector<Look>& shortLooks) const;
    std::vector<FaceStretch> failing(const std::vector<Look>& looks) const;
    VerdictItem judgeShort(const std::vector<Look>& looks, const std::vector<Look>& shortLooks) const;
    /// Total length (mm) of stations that `counts` accepts, in the window of ShortAllowance::per where it is longest.
    template <class Counts>
    double longest(const std::vector<Look>& looks, Counts counts) const;

    const WeldMeasures& measures_;
    const AcceptanceItem& item_;
    const NominalWeld& nominal_;
    const WeldFigure& what_;
    double resolution_; ///< resolution in the imperfection's unit
    LimitSizes sizes_;  ///< sizes of the whole weld, without b
};

/// All values of the imperfection, in the order of the stations.
std::vector<PlacedImperfection> ItemJudge::found() const {
    std::vector<PlacedImperfection> all;
    if (what_.judged)
        for (const WeldStation& station : measures_.stations)
            if (const auto value = what_.judged(station, nominal_, measures_.kind))
                all.push_back({*value, station.place});
    if (what_.judgedWhole)
        if (const auto once = what_.judgedWhole(measures_, nominal_)) all.push_back(*once);
    return all;
}

Look ItemJudge::look(const PlacedImperfection& told, const LimitFormula& formula) const {
    LimitSizes sizes = sizes_;
    sizes.b = told.found.width;
    const bool isAngle = what_.unit == "deg";
    Look look;
    look.value = told.found.value;
    look.limit = formula.at(sizes);
    look.excess = item_.kind == LimitKind::atLeast ? look.limit - told.found.value : told.found.value - look.limit;
    look.resolution = resolution_;
    look.state = stateOf(look.excess, look.limit, look.resolution, isAngle);
    look.place = told.place;
    return look;
}

VerdictItem ItemJudge::blank() const {
    VerdictItem item;
    item.name = what_.key;
    item.kind = item_.kind;
    item.unit = what_.unit;
    item.resolution = resolution_;
    if (const double limit = item_.formula.at(sizes_); std::isfinite(limit)) item.limit = limit;
    return item;
}

VerdictItem ItemJudge::made(const Look& look, VerdictState state) const {
    VerdictItem item = blank();
    item.value = item_.kind == LimitKind::atLeast ? look.value : std::max(look.value, 0.0);
    item.limit = std::isfinite(look.limit) ? std::optional(look.limit) : std::nullopt;
    item.state = state;
    item.beyond = look.excess > 0;
    item.resolution = look.resolution;
    item.place = look.place;
    return item;
}

/// Writes an estimate into an item.
void takeEstimate(VerdictItem& item, const Estimate& estimate) {
    item.value = estimate.value;
    item.limit.reset();
    item.state = VerdictState::estimated;
    item.beyond = estimate.value > 0;
    item.rule = estimate.rule;
}

VerdictItem ItemJudge::judgeEstimate(const Estimate& estimate) const {
    VerdictItem item = blank();
    takeEstimate(item, estimate);
    return item;
}

std::optional<VerdictItem> ItemJudge::judge() const {
    if (!item_.appliesToKind(measures_.kind) || !item_.holdsFor(sizes_)) return std::nullopt;
    std::vector<Look> looks, shortLooks;
    const std::vector<PlacedImperfection> all = found();
    for (const PlacedImperfection& each : all) {
        if (!item_.b.contains(each.found.width)) continue;
        looks.push_back(look(each, item_.formula));
        if (item_.shortOnes) shortLooks.push_back(look(each, item_.shortOnes->formula));
    }
    if (all.empty()) return blank();
    if (looks.empty()) return std::nullopt;
    VerdictItem item = decide(looks, shortLooks);
    if (item.state == VerdictState::fail) item.failing = failing(looks);
    return item;
}

VerdictItem ItemJudge::decide(const std::vector<Look>& looks, const std::vector<Look>& shortLooks) const {
    if (item_.shortOnes) return judgeShort(looks, shortLooks);
    const Look& worst =
        *std::max_element(looks.begin(), looks.end(), [](const Look& a, const Look& b) { return worse(b, a); });
    return made(worst, worst.state);
}

/// Stretches of failing stations. `looks` are in the order of the stations.
std::vector<FaceStretch> ItemJudge::failing(const std::vector<Look>& looks) const {
    std::vector<FaceStretch> stretches;
    for (const Look& look : looks) {
        if (look.state != VerdictState::fail) continue;
        const double low = look.place - measures_.pitch / 2, high = look.place + measures_.pitch / 2;
        if (!stretches.empty() && low - stretches.back().high < measures_.pitch / 2)
            stretches.back().high = high;
        else
            stretches.push_back({low, high});
    }
    return stretches;
}

template <class Counts>
double ItemJudge::longest(const std::vector<Look>& looks, Counts counts) const {
    double most = 0;
    for (const Look& first : looks) {
        double length = 0;
        for (const Look& each : looks) {
            const double beyond = (each.place - first.place) * kPerMetre;
            if (counts(each) && beyond > -kRounding && beyond < item_.shortOnes->per - kRounding)
                length += measures_.pitch * kPerMetre;
        }
        most = std::max(most, length);
    }
    return most;
}

VerdictItem ItemJudge::judgeShort(const std::vector<Look>& looks, const std::vector<Look>& shortLooks) const {
    const auto lesser = [](const Look& a, const Look& b) { return worse(b, a); };
    const Look& worst = *std::max_element(looks.begin(), looks.end(), lesser);
    if (worst.state == VerdictState::pass) return made(worst, VerdictState::pass);
    // These stations against the limit of short ones; a station within the main limit needs no allowance.
    Look worstShort;
    bool any = false;
    for (size_t i = 0; i < looks.size(); ++i) {
        if (looks[i].state == VerdictState::pass || (any && !worse(shortLooks[i], worstShort))) continue;
        worstShort = shortLooks[i];
        any = true;
    }
    if (worst.state == VerdictState::fail && worstShort.state == VerdictState::fail)
        return made(worstShort, VerdictState::fail);
    const double allowed = item_.shortOnes->allowed(measures_.length() * kPerMetre) + kRounding;
    if (longest(looks, [](const Look& each) { return each.state == VerdictState::fail; }) > allowed)
        return made(worst, VerdictState::fail);
    if (longest(looks, [](const Look& each) { return each.state != VerdictState::pass; }) > allowed)
        return made(worst, VerdictState::notResolved);
    return made(worstShort, worstShort.state);
}

/// Adds an item, or replaces a better one of the same imperfection.
void enter(std::vector<VerdictItem>& items, VerdictItem item) {
    const auto same =
        std::find_if(items.begin(), items.end(), [&](const VerdictItem& each) { return each.name == item.name; });
    if (same == items.end())
        items.push_back(std::move(item));
    else if (severity(item.state) > severity(same->state))
        *same = std::move(item);
}

/// The estimate of an imperfection that the metal does not contain; null if there is none.
const Estimate* findEstimate(std::span<const Estimate> estimates, const WeldFigure& imperfection) {
    if (imperfection.isMeasured()) return nullptr;
    const auto found = std::find_if(estimates.begin(), estimates.end(),
                                    [&](const Estimate& each) { return each.name == imperfection.estimate; });
    return found == estimates.end() ? nullptr : &*found;
}

/// Adds estimates that no item of the file asks for.
void enterFreeEstimates(std::span<const Estimate> estimates, std::vector<VerdictItem>& items) {
    for (const Estimate& estimate : estimates) {
        const auto known = [&](const VerdictItem& each) {
            return findImperfection(each.name)->estimate == estimate.name;
        };
        if (std::any_of(items.begin(), items.end(), known)) continue;
        VerdictItem item;
        item.name = estimate.name;
        item.unit = findImperfection(estimate.name)->unit;
        takeEstimate(item, estimate);
        items.push_back(std::move(item));
    }
}

} // namespace

std::optional<VerdictItem> judgeItem(const WeldMeasures& measures, const AcceptanceItem& item,
                                     const WeldFigure& imperfection, const NominalWeld& nominal) {
    return ItemJudge(measures, item, imperfection, nominal).judge();
}

Verdict judge(const WeldMeasures& measures, const Acceptance& acceptance, const NominalWeld& nominal,
              std::span<const Estimate> estimates) {
    Verdict verdict{acceptance.standard, acceptance.edition, acceptance.level, {}, !measures.stations.empty()};
    for (const AcceptanceItem& item : acceptance.items) {
        const WeldFigure& imperfection = *findImperfection(item.imperfection);
        const ItemJudge judge(measures, item, imperfection, nominal);
        auto judged = judge.judge();
        if (!judged) continue;
        if (const Estimate* estimate = findEstimate(estimates, imperfection)) judged = judge.judgeEstimate(*estimate);
        enter(verdict.items, std::move(*judged));
    }
    enterFreeEstimates(estimates, verdict.items);
    for (const VerdictItem& item : verdict.items)
        verdict.accepted = verdict.accepted && item.state != VerdictState::fail;
    return verdict;
}

} // namespace meltpool
