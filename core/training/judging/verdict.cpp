#include "core/training/judging/verdict.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kPerMetre = 1e3;  ///< mm
constexpr double kRounding = 1e-6; ///< mm, rounding of sums of pitches
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

int severity(VerdictState state) {
    if (state == VerdictState::fail) return 2;
    return state == VerdictState::pass ? 0 : 1;
}

/// A run of stations with its state.
struct Finding {
    ReadingRun run;
    VerdictState state = VerdictState::notResolved;
    /// Stations whose excess names the failing stretches; see VerdictItem::failing.
    std::vector<FaceStretch> failing = {};
};

bool worse(const Finding& a, const Finding& b) {
    if (severity(a.state) != severity(b.state)) return severity(a.state) > severity(b.state);
    return a.run.excess > b.run.excess;
}

/// Judges the readings of one side of a weld by one item, by the rule of judge().
class SideJudge {
  public:
    SideJudge(const AcceptanceItem& item, const WeldFigure& figure, const ReadingUncertainty& uncertainty,
              double weldLength, std::vector<Reading> readings)
        : item_(item),
          figure_(figure),
          uncertainty_(uncertainty),
          weldLength_(weldLength),
          readings_(std::move(readings)) {}

    Finding find() const;

  private:
    VerdictState stateOf(const Reading& reading) const { return decide(reading.excess, uncertainty_.single); }
    VerdictState shortState(const Reading& reading) const { return decide(reading.shortExcess, uncertainty_.single); }
    /// Length (mm) over which a run of `count` stations may have the limit of short ones.
    double allowedIn(size_t count) const;
    ReadingRun runOf(size_t first, size_t count) const;
    /// All stations. `allowed`: mm of them with the limit of short ones.
    ReadingRun whole(double allowed) const;
    /// The station alone at its limit, or at that of short ones.
    ReadingRun alone(size_t station, bool atShortLimit = false) const;
    /// The run whose mean is farthest beyond its limit and uncertainty; nothing if none fails.
    std::optional<ReadingRun> worstFailingRun() const;
    Finding failed(const ReadingRun& run) const;
    size_t worstStation() const;
    /// Total length (mm) of stations that `counts` accepts, in the window of ShortAllowance::per where it is longest.
    template <class Counts>
    double longest(Counts counts) const;
    bool isNext(size_t station) const {
        return readings_[station].place - readings_[station - 1].place < 1.5 * uncertainty_.pitch;
    }
    Finding findUnfailed() const;
    std::vector<FaceStretch> stretchesOf(const ReadingRun& run) const;

    const AcceptanceItem& item_;
    const WeldFigure& figure_;
    ReadingUncertainty uncertainty_;
    double weldLength_; ///< mm
    std::vector<Reading> readings_;
};

double SideJudge::allowedIn(size_t count) const {
    if (!item_.shortOnes) return 0;
    const double length = static_cast<double>(count) * uncertainty_.pitch * kPerMetre;
    const double windows = std::isfinite(item_.shortOnes->per) ? std::ceil(length / item_.shortOnes->per) : 1;
    return item_.shortOnes->allowed(weldLength_) * std::max(windows, 1.0);
}

ReadingRun SideJudge::runOf(size_t first, size_t count) const {
    return meanOf(readings_, first, count, allowedIn(count) / kPerMetre, uncertainty_);
}

ReadingRun SideJudge::whole(double allowed) const {
    ReadingRun run = meanOf(readings_, 0, readings_.size(), allowed / kPerMetre, uncertainty_);
    std::vector<double> values;
    for (const Reading& reading : readings_)
        values.push_back(reading.excess);
    run.uncertainty = uncertainty_.ofWhole(values);
    return run;
}

ReadingRun SideJudge::alone(size_t station, bool atShortLimit) const {
    return meanOf(readings_, station, 1, atShortLimit ? uncertainty_.pitch : 0, uncertainty_);
}

std::optional<ReadingRun> SideJudge::worstFailingRun() const {
    std::optional<ReadingRun> worst;
    const auto take = [&](const ReadingRun& run) {
        const bool fails = decide(run.excess, run.uncertainty) == VerdictState::fail;
        if (!fails || (worst && run.margin() < worst->margin() - kRounding)) return;
        if (!worst || run.margin() > worst->margin() + kRounding || run.count > worst->count) worst = run;
    };
    // A single station that fails comes before any mean: it shows the place.
    for (size_t i = 0; i < readings_.size(); ++i)
        take(runOf(i, 1));
    if (worst) return worst;
    for (size_t first = 0; first < readings_.size(); ++first)
        for (size_t end = first + 1; end < readings_.size() && isNext(end); ++end)
            take(runOf(first, end - first + 1));
    take(whole(allowedIn(readings_.size())));
    return worst;
}

size_t SideJudge::worstStation() const {
    size_t worst = 0;
    for (size_t i = 1; i < readings_.size(); ++i)
        if (readings_[i].excess > readings_[worst].excess) worst = i;
    return worst;
}

std::vector<FaceStretch> SideJudge::stretchesOf(const ReadingRun& run) const {
    const bool single = std::any_of(readings_.begin(), readings_.end(),
                                    [&](const Reading& each) { return stateOf(each) == VerdictState::fail; });
    std::vector<FaceStretch> stretches;
    for (size_t i = single ? 0 : run.first; i < (single ? readings_.size() : run.first + run.count); ++i) {
        const Reading& reading = readings_[i];
        if (single ? stateOf(reading) != VerdictState::fail : !(reading.excess > 0)) continue;
        const double low = reading.place - uncertainty_.pitch / 2, high = reading.place + uncertainty_.pitch / 2;
        if (!stretches.empty() && low - stretches.back().high < uncertainty_.pitch / 2)
            stretches.back().high = high;
        else
            stretches.push_back({low, high});
    }
    return stretches;
}

Finding SideJudge::failed(const ReadingRun& run) const {
    return {run, VerdictState::fail, stretchesOf(run)};
}

template <class Counts>
double SideJudge::longest(Counts counts) const {
    double most = 0;
    for (const Reading& first : readings_) {
        double length = 0;
        for (const Reading& each : readings_) {
            const double beyond = (each.place - first.place) * kPerMetre;
            if (counts(each) && beyond > -kRounding && beyond < item_.shortOnes->per - kRounding)
                length += uncertainty_.pitch * kPerMetre;
        }
        most = std::max(most, length);
    }
    return most;
}

/// Pass or not resolved, of readings of which no run fails.
Finding SideJudge::findUnfailed() const {
    const ReadingRun mean = whole(0);
    if (figure_.meanDecides && decide(mean.excess, mean.uncertainty) == VerdictState::pass)
        return {mean, VerdictState::pass};
    const size_t worst = worstStation();
    if (stateOf(readings_[worst]) == VerdictState::pass) return {alone(worst), VerdictState::pass};
    const auto unpassed = [&](const Reading& each) { return stateOf(each) != VerdictState::pass; };
    if (item_.shortOnes && longest(unpassed) <= item_.shortOnes->allowed(weldLength_) + kRounding)
        return {alone(worst, true), shortState(readings_[worst])};
    return {figure_.meanDecides ? mean : alone(worst), VerdictState::notResolved};
}

Finding SideJudge::find() const {
    if (const auto run = worstFailingRun()) return failed(*run);
    const auto fails = [&](const Reading& each) { return stateOf(each) == VerdictState::fail; };
    if (item_.shortOnes && longest(fails) > item_.shortOnes->allowed(weldLength_) + kRounding)
        return failed(alone(worstStation()));
    return findUnfailed();
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
          uncertainty_{resolvedOf(what_, measures.spacing), gaugeErrorOf(what_, measures.spacing), measures.cut,
                       measures.pitch},
          sizes_{kUnknown, nominal.throatOf(measures.kind).value_or(kUnknown) * kPerMetre,
                 nominal.thickness * kPerMetre, nominal.legOf().value_or(kUnknown) * kPerMetre} {}

    /// Empty if the item does not apply to this weld.
    std::optional<VerdictItem> judge() const;
    /// Judges an estimate by the item.
    VerdictItem judgeEstimate(const Estimate& estimate) const;

  private:
    using Side = std::vector<PlacedImperfection>;

    /// All values of the imperfection by sides, in the order of the stations.
    std::vector<Side> found() const;
    Reading read(const PlacedImperfection& told) const;
    VerdictItem blank() const;
    VerdictItem made(const Finding& finding) const;

    const WeldMeasures& measures_;
    const AcceptanceItem& item_;
    const NominalWeld& nominal_;
    const WeldFigure& what_;
    ReadingUncertainty uncertainty_;
    LimitSizes sizes_; ///< sizes of the whole weld, without b
};

std::vector<ItemJudge::Side> ItemJudge::found() const {
    std::vector<Side> sides;
    for (const auto judged : {what_.judged, what_.judgedOther}) {
        if (!judged) continue;
        Side& side = sides.emplace_back();
        for (const WeldStation& station : measures_.stations)
            if (const auto value = judged(station, nominal_, measures_.kind)) side.push_back({*value, station.place});
    }
    if (what_.judgedWhole)
        if (const auto once = what_.judgedWhole(measures_, nominal_)) sides.push_back({*once});
    return sides;
}

Reading ItemJudge::read(const PlacedImperfection& told) const {
    LimitSizes sizes = sizes_;
    sizes.b = told.found.width;
    const double sign = item_.kind == LimitKind::atLeast ? -1 : 1;
    Reading reading;
    reading.place = told.place;
    reading.value = told.found.value;
    reading.limit = item_.formula.at(sizes);
    reading.shortLimit = item_.shortOnes ? std::max(item_.shortOnes->formula.at(sizes), reading.limit) : reading.limit;
    reading.excess = sign * (reading.value - reading.limit);
    reading.shortExcess = sign * (reading.value - reading.shortLimit);
    if (told.found.ruledOut) { // as sure as a value that passes by itself
        reading.excess = std::min(reading.excess, -uncertainty_.single);
        reading.shortExcess = std::min(reading.shortExcess, -uncertainty_.single);
    }
    return reading;
}

VerdictItem ItemJudge::blank() const {
    VerdictItem item;
    item.name = what_.key;
    item.kind = item_.kind;
    item.unit = what_.unit;
    item.uncertainty = uncertainty_.single;
    if (const double limit = item_.formula.at(sizes_); std::isfinite(limit)) item.limit = limit;
    return item;
}

VerdictItem ItemJudge::made(const Finding& finding) const {
    VerdictItem item = blank();
    const ReadingRun& run = finding.run;
    item.value = item_.kind == LimitKind::atLeast ? run.value : std::max(run.value, 0.0);
    item.limit = std::isfinite(run.limit) ? std::optional(run.limit) : std::nullopt;
    item.state = finding.state;
    item.beyond = run.excess > 0;
    item.uncertainty = run.uncertainty;
    item.place = run.place;
    if (run.count > 1) item.meanOver = static_cast<double>(run.count) * measures_.pitch;
    item.failing = finding.failing;
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
    bool any = false;
    std::optional<Finding> worst;
    for (const Side& side : found()) {
        any = any || !side.empty();
        std::vector<Reading> readings;
        for (const PlacedImperfection& each : side)
            if (item_.b.contains(each.found.width)) readings.push_back(read(each));
        if (readings.empty()) continue;
        const Finding finding =
            SideJudge(item_, what_, uncertainty_, measures_.length() * kPerMetre, std::move(readings)).find();
        if (!worst || worse(finding, *worst)) worst = finding;
    }
    if (!any) return blank();
    return worst ? std::optional(made(*worst)) : std::nullopt;
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

size_t Verdict::notAssessed() const {
    return static_cast<size_t>(std::count_if(items.begin(), items.end(), [](const VerdictItem& each) {
        return each.state == VerdictState::notResolved || each.state == VerdictState::estimated;
    }));
}

std::optional<VerdictItem> judgeItem(const WeldMeasures& measures, const AcceptanceItem& item,
                                     const WeldFigure& imperfection, const NominalWeld& nominal) {
    return ItemJudge(measures, item, imperfection, nominal).judge();
}

Verdict judge(const WeldMeasures& measures, const Acceptance& acceptance, const NominalWeld& nominal,
              std::span<const Estimate> estimates) {
    Verdict verdict{acceptance.standard, acceptance.edition, acceptance.level, {}, !measures.stations.empty()};
    verdict.judgedLength = measures.length();
    verdict.askedLength = measures.asked;
    verdict.complete = measures.isComplete();
    verdict.accepted = verdict.accepted && verdict.complete;
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
