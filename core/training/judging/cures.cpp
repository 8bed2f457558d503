#include "core/training/judging/cures.hpp"

#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/training/judging/cure_causes.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

using enum TechniqueQuantity;

constexpr double kMm = 1e3;            ///< mm in a metre
constexpr double kAround = 1e-3;       ///< m beyond the failing stretch whose hand counts too
constexpr double kPlaceAlone = 2e-3;   ///< m on both sides of a failing place without a stretch
constexpr double kOtherSetting = 0.02; ///< share of the demonstration's value from which a setting differs
constexpr double kChange = 0.12;       ///< share of a setting by which a remedy changes it

/// Number for a sentence, with one digit behind the point.
std::string told(double value) {
    const double rounded = std::round(value * 10) / 10;
    return withDecimalMark(formatNumber(rounded == 0 ? 0.0 : rounded));
}

/// Value of a setting for a sentence: 29.5, 0.75.
std::string toldSetting(double value) {
    return withDecimalMark(formatNumber(static_cast<float>(std::round(value * 100) / 100)));
}

/// Number for a wish, which has a point in every language.
std::string typed(double value, double step = 0.1) {
    return formatNumber(static_cast<float>(std::round(value / step) * step));
}

struct Stretch {
    double from = 0, to = 0; ///< m along the seam
};

/// The failing stretch with the item's worst place; nothing for an item without a place.
std::optional<Stretch> stretchOf(const VerdictItem& item) {
    if (!item.place) return std::nullopt;
    for (const FaceStretch& each : item.failing)
        if (*item.place >= each.low && *item.place <= each.high)
            return Stretch{each.low - kAround, each.high + kAround};
    return Stretch{*item.place - kPlaceAlone, *item.place + kPlaceAlone};
}

/// Finds the cure of one failed item.
class CureFinder {
  public:
    CureFinder(const VerdictItem& item, const CureFacts& facts)
        : facts_(facts), cure_{item.name, {}}, stretch_(stretchOf(item)) {
        const std::string name = capitalised(imperfectionName(item.name));
        fault_ = item.place ? phrase("cure.fault", {{"imperfection", name}, {"place", told(*item.place * kMm)}}) : name;
    }

    Cure find() {
        if (!byMissingArc() && !byHand() && !bySetting() && !byDemonstration() && !byGuess())
            cure_.sentence = phrase("cure.unknown", {{"fault", fault_}});
        return std::move(cure_);
    }

  private:
    /// Rows of this imperfection and process; `ofHand`: those of the hand, else those of settings.
    std::vector<const CureCause*> rows(bool ofHand) const {
        std::vector<const CureCause*> found;
        for (const CureCause& each : cureCauses())
            if (each.imperfection == cure_.imperfection && each.hand.has_value() == ofHand &&
                (each.only == nullptr || each.only(facts_.process)))
                found.push_back(&each);
        return found;
    }

    const SettingFact* setting(std::string_view key) const {
        const auto found = std::find_if(facts_.settings.begin(), facts_.settings.end(),
                                        [&](const SettingFact& each) { return each.key == key; });
        return found == facts_.settings.end() ? nullptr : &*found;
    }

    static bool explains(const CureCause& row, double deviation) { return row.sign == 0 || row.sign * deviation > 0; }
    const std::string& effect(const CureCause& row) const { return phraseOf("cure.effect", nameOf(row.effect)); }

    bool byMissingArc();
    bool byHand();
    bool bySetting();
    bool byDemonstration();
    bool byGuess();
    bool handIsRight() const;
    ParameterScore local(const TechniqueBand& band) const;
    void takePathWish(const TechniqueBand& band, int sign);
    void takeSettingWish(const SettingFact& fact, double value);

    const CureFacts& facts_;
    Cure cure_;
    std::optional<Stretch> stretch_;
    std::string fault_; ///< "Overlap at 12 mm"
};

ParameterScore CureFinder::local(const TechniqueBand& band) const {
    return scoreStretch(facts_.seam, stretch_->from, stretch_->to, *facts_.bands, band);
}

/// The arc passed nowhere over the failing stretch, or only with strike or crater.
bool CureFinder::byMissingArc() {
    if (!stretch_ || rows(true).empty()) return false;
    const auto within = [&](double place) { return place >= stretch_->from && place <= stretch_->to; };
    if (std::any_of(facts_.unknown.begin(), facts_.unknown.end(), within)) return false;
    bool any = false, judged = false;
    for (const SeamMillimetre& mm : facts_.seam) {
        if (!within(mm.place)) continue;
        any = true;
        judged = judged || mm.judged;
    }
    if (judged) return false;
    const WeldFigure* figure = findImperfection(cure_.imperfection);
    const bool ofCrater = figure != nullptr && figure->judgedWhole != nullptr;
    cure_.sentence = phrase(ofCrater ? "cure.crater"
                            : any    ? "cure.strike_or_crater"
                                     : "cure.no_arc",
                            {{"fault", fault_}});
    return true;
}

bool CureFinder::byHand() {
    if (!stretch_ || facts_.bands == nullptr) return false;
    const CureCause* found = nullptr;
    const TechniqueBand* foundBand = nullptr;
    ParameterScore worst;
    double most = 0;
    for (const CureCause* row : rows(true)) {
        const TechniqueBand* band = facts_.bands->find(*row->hand);
        if (band == nullptr) continue;
        const ParameterScore parameter = local(*band);
        if (std::isnan(parameter.mean) || !band->readsBeyond(parameter.mean) || !explains(*row, parameter.deviation))
            continue;
        const double size = std::abs(parameter.deviation) / band->outer;
        if (size <= most) continue;
        most = size;
        found = row;
        foundBand = band;
        worst = parameter;
    }
    if (found == nullptr) return false;
    cure_.sentence = phrase("cure.hand", {{"fault", fault_},
                                          {"effect", effect(*found)},
                                          {"correction", correctionSentence(worst, *foundBand, *facts_.bands)}});
    takePathWish(*foundBand, worst.deviation > 0 ? 1 : -1);
    return true;
}

/// A what-if changes the whole path, so there is a wish only if the whole path deviates to that side.
void CureFinder::takePathWish(const TechniqueBand& band, int sign) {
    const ParameterScore whole = scoreStretch(facts_.seam, -1e9, 1e9, *facts_.bands, band);
    if (std::isnan(whole.mean) || !band.readsBeyond(whole.mean) || whole.deviation * sign <= 0) return;
    const QuantityInfo& info = quantityInfo(band.quantity, facts_.bands->distance);
    switch (band.quantity) {
    case travelSpeed:
        if (whole.mean <= 0) return;
        cure_.whatIf = "speed=" + typed(band.ideal) + "mm/s";
        break;
    case distance:
        cure_.whatIf = (facts_.bands->distance == DistanceKind::arcLength ? "arc_length=" : "stick_out=") +
                       typed(-whole.deviation);
        break;
    case workAngle:
    case travelAngle:
        cure_.whatIf = std::string(info.key) + "=" + typed(-whole.deviation);
        break;
    default:
        return;
    }
    cure_.change =
        phrase("cure.change_of_hand",
               {{"quantity", info.words()}, {"to", told(band.ideal)}, {"unit", info.unit}, {"from", told(whole.mean)}});
}

void CureFinder::takeSettingWish(const SettingFact& fact, double value) {
    if (value < fact.lowest || value > fact.highest) return;
    cure_.whatIf = fact.key + "=" + formatNumber(static_cast<float>(value));
    cure_.change = phrase(
        "cure.change_of_setting",
        {{"setting", fact.name}, {"to", toldSetting(value)}, {"unit", fact.unit}, {"from", toldSetting(fact.value)}});
}

bool CureFinder::bySetting() {
    const CureCause* found = nullptr;
    const SettingFact* worst = nullptr;
    double most = 0;
    for (const CureCause* row : rows(false)) {
        const SettingFact* fact = setting(row->setting);
        if (fact == nullptr || (fact->value >= fact->least && fact->value <= fact->most)) continue;
        const double off = fact->value - fact->asked;
        const double size = std::abs(off) / std::max(std::abs(fact->asked), 1e-9);
        if (!explains(*row, off) || size <= most || toldSetting(fact->value) == toldSetting(fact->asked)) continue;
        most = size;
        found = row;
        worst = fact;
    }
    if (found == nullptr) return false;
    cure_.sentence = phrase(worst->ofMachine ? "cure.setting" : "cure.workpiece", {{"fault", fault_},
                                                                                   {"effect", effect(*found)},
                                                                                   {"setting", worst->name},
                                                                                   {"asked", toldSetting(worst->asked)},
                                                                                   {"value", toldSetting(worst->value)},
                                                                                   {"unit", worst->unit}});
    takeSettingWish(*worst, worst->asked);
    return true;
}

/// A chosen setting within the lesson's limits, on the side that explains the imperfection.
bool CureFinder::byDemonstration() {
    for (const CureCause* row : rows(false)) {
        const SettingFact* fact = setting(row->setting);
        if (fact == nullptr || !fact->ofMachine) continue;
        const double off = fact->value - fact->asked;
        if (std::abs(off) <= kOtherSetting * std::abs(fact->asked) || !explains(*row, off)) continue;
        cure_.sentence = phrase("cure.demonstration", {{"fault", fault_},
                                                       {"effect", effect(*row)},
                                                       {"setting", fact->name},
                                                       {"asked", toldSetting(fact->asked)},
                                                       {"value", toldSetting(fact->value)},
                                                       {"unit", fact->unit}});
        takeSettingWish(*fact, fact->asked);
        return true;
    }
    return false;
}

/// True if the hand kept all tolerances over the failing stretch.
bool CureFinder::handIsRight() const {
    if (!stretch_ || facts_.bands == nullptr) return false;
    return std::none_of(facts_.bands->bands.begin(), facts_.bands->bands.end(), [&](const TechniqueBand& band) {
        const ParameterScore parameter = local(band);
        return std::isnan(parameter.mean) || band.readsBeyond(parameter.mean);
    });
}

/// The likeliest setting that can still be moved.
bool CureFinder::byGuess() {
    for (const CureCause* row : rows(false)) {
        const SettingFact* fact = setting(row->setting);
        if (fact == nullptr || !fact->ofMachine || row->sign == 0) continue;
        const double step = std::abs(fact->value) < 10 ? 0.1 : std::abs(fact->value) < 50 ? 0.5 : 5;
        const double wanted = std::round(fact->value * (1 - row->sign * kChange) / step) * step;
        const double value = std::clamp(wanted, fact->lowest, fact->highest);
        if (std::abs(value - fact->value) < 0.5 * kChange * std::abs(fact->value)) continue;
        cure_.sentence =
            phrase(handIsRight() ? "cure.guess" : "cure.guess_unexplained", {{"fault", fault_},
                                                                             {"effect", effect(*row)},
                                                                             {"setting", fact->name},
                                                                             {"to", toldSetting(value)},
                                                                             {"value", toldSetting(fact->value)},
                                                                             {"unit", fact->unit}});
        takeSettingWish(*fact, value);
        return true;
    }
    return false;
}

std::string namesOf(const std::vector<std::string>& keys) {
    std::string names;
    for (const std::string& key : keys)
        names += (names.empty() ? "" : phrase("list.separator")) + imperfectionName(key);
    return names;
}

} // namespace

std::vector<Cure> curesOf(const Verdict& verdict, const CureFacts& facts) {
    std::vector<Cure> cures;
    for (const VerdictItem& item : verdict.items)
        if (item.state == VerdictState::fail) cures.push_back(CureFinder(item, facts).find());
    return cures;
}

std::string whatIfOutcome(std::string_view change, std::span<const std::string> failed,
                          std::span<const std::string> failedThen) {
    std::vector<std::string> passed, still, only;
    const auto has = [](std::span<const std::string> list, const std::string& key) {
        return std::find(list.begin(), list.end(), key) != list.end();
    };
    for (const std::string& key : failed)
        (has(failedThen, key) ? still : passed).push_back(key);
    for (const std::string& key : failedThen)
        if (!has(failed, key)) only.push_back(key);
    std::string text;
    if (passed.empty())
        text = phrase("what_if.none_passed", {{"changes", change}});
    else
        text = phrase(failedThen.empty() ? "what_if.accepted" : "what_if.passed",
                      {{"changes", change}, {"imperfections", namesOf(passed)}});
    if (!still.empty()) text += " " + phrase("what_if.still_failing", {{"imperfections", namesOf(still)}});
    if (!only.empty()) text += " " + phrase("what_if.failing_then", {{"imperfections", namesOf(only)}});
    return text;
}

std::vector<std::string> failedKeys(const Verdict& verdict) {
    std::vector<std::string> keys;
    for (const VerdictItem& item : verdict.items)
        if (item.state == VerdictState::fail) keys.push_back(item.name);
    return keys;
}

} // namespace meltpool
