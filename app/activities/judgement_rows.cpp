#include "app/activities/judgement_rows.hpp"

#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace meltpool {

namespace {

constexpr double kGood = 90; ///< points from which a parameter counts as good
constexpr double kBad = 70;  ///< points below which it counts as bad

std::string rounded(double value, int digits) {
    const double scale = std::pow(10.0, digits);
    const double number = std::round(value * scale) / scale;
    return withDecimalMark(formatNumber(number == 0 ? 0.0 : number));
}

std::string withUnit(const std::string& number, std::string_view unit) {
    if (unit == "\xC2\xB0" || unit == "deg") return number + "\xC2\xB0";
    return std::string(inShownUnit(number, unit)) + " " + std::string(shownUnit(unit).name);
}

/// Key of the sentence in which a sign means a side; empty if it means more or less.
std::string_view sideKey(TechniqueQuantity quantity, double value) {
    switch (quantity) {
    case TechniqueQuantity::aim:
        return value > 0 ? "judgement.side.near" : "judgement.side.far";
    case TechniqueQuantity::workAngle:
        return value > 0 ? "judgement.side.towards" : "judgement.side.away";
    case TechniqueQuantity::travelAngle:
        return value > 0 ? "judgement.side.push" : "judgement.side.drag";
    default:
        return {};
    }
}

/// Text of a value: "8\xC2\xB0 push", "0.4 mm to your side", "7.6 mm/s".
std::string valueText(const QuantityInfo& info, double value) {
    const std::string number = rounded(value, info.unit == "\xC2\xB0" ? 0 : 1);
    const std::string_view key = sideKey(info.quantity, value);
    if (number == "0" || key.empty()) return withUnit(number, info.unit);
    return phrase(key, {{"value", withUnit(number[0] == '-' ? number.substr(1) : number, info.unit)}});
}

/// The mean, and the target if there is a band.
std::string techniqueDetail(const ParameterScore& parameter, const TechniqueBand* band, const QuantityInfo& info) {
    const bool known = !std::isnan(parameter.mean);
    const std::string mean = known ? valueText(info, parameter.mean) : std::string();
    if (band == nullptr) return phrase(known ? "judgement.hand.mean" : "judgement.hand.unknown", {{"mean", mean}});
    return phrase(known ? "judgement.hand.mean_asked" : "judgement.hand.unknown_asked",
                  {{"mean", mean},
                   {"asked", valueText(info, band->ideal)},
                   {"tolerance", withUnit(rounded(band->inner, 1), info.unit)}});
}

JudgementRow techniqueRow(const ParameterScore& parameter, const TechniqueBand* band, DistanceKind distance,
                          const QuantitySet& held) {
    const QuantityInfo& info = quantityInfo(parameter.quantity, distance);
    JudgementRow row{capitalised(info.words()),
                     phrase("judgement.hand.points", {{"points", rounded(parameter.score, 0)}}),
                     techniqueDetail(parameter, band, info), RowState::plain};
    if (held.test(static_cast<size_t>(parameter.quantity))) {
        row.detail += ". " + phrase("judgement.hand.held");
        return row;
    }
    if (parameter.score >= kGood) row.state = RowState::good;
    if (parameter.score < kBad) row.state = RowState::bad;
    return row;
}

/// The scored quantities that the desk held, as a sentence; empty if there are none.
std::string heldSentence(const TechniqueScore& score, DistanceKind distance, const QuantitySet& held) {
    QuantitySet scored;
    for (const ParameterScore& parameter : score.parameters)
        scored.set(static_cast<size_t>(parameter.quantity));
    const QuantitySet both = scored & held;
    if (both.none()) return {};
    if (both == scored) return phrase("judgement.score.all_held");
    return phrase("judgement.score.held", {{"quantities", wordsOfKeys(keysOf(both, distance))}});
}

void addTechnique(JudgementRows& rows, const Judgement& judgement, const TechniqueBands* bands,
                  const QuantitySet& held) {
    rows.technique.title = phrase("judgement.hand.heading");
    if (!judgement.score) {
        rows.score = phrase("judgement.score.none");
        rows.scoreNote = phrase("judgement.score.no_technique");
        rows.technique.note = rows.scoreNote;
        return;
    }
    const TechniqueScore& score = *judgement.score;
    if (!score.scored) {
        rows.score = phrase("judgement.score.not_scored");
        rows.scoreNote = score.reason;
        rows.technique.note = phrase("judgement.hand.not_scored");
        return;
    }
    rows.scored = true;
    rows.score = phrase("judgement.score.points", {{"points", rounded(score.total, 0)}});
    rows.scoreNote = phrase("judgement.score.welded",
                            {{"welded", rounded(score.weldedMm, 0)}, {"wanted", rounded(score.wantedMm, 0)}});
    if (score.unknownMm > 0) rows.scoreNote += " " + unknownSentence(score);
    if (const std::string sentence = heldSentence(score, judgement.distance, held); !sentence.empty())
        rows.scoreNote += " " + sentence;
    for (const ParameterScore& parameter : score.parameters)
        rows.technique.rows.push_back(techniqueRow(
            parameter, bands == nullptr ? nullptr : bands->find(parameter.quantity), judgement.distance, held));
}

std::string limitText(const VerdictItem& item) {
    if (!item.limit) return phrase("judgement.limit.none");
    if (item.kind == LimitKind::notPermitted) return phrase("judgement.limit.not_permitted");
    return phrase(item.kind == LimitKind::atLeast ? "judgement.limit.at_least" : "judgement.limit.at_most",
                  {{"limit", withUnit(rounded(*item.limit, 1), item.unit)}});
}

/// The value with its uncertainty, if it has one.
std::string valueText(const VerdictItem& item) {
    const std::string value = withUnit(rounded(*item.value, 1), item.unit);
    if (!(item.uncertainty > 0)) return value;
    return phrase(item.meanOver > 0 ? "judgement.item.mean" : "judgement.item.uncertain",
                  {{"value", value},
                   {"uncertainty", withUnit(rounded(item.uncertainty, 1), item.unit)},
                   {"length", rounded(item.meanOver * 1e3, 0)}});
}

/// True for an imperfection that the metal never shows, such as a crack.
bool isNotSimulated(const VerdictItem& item) {
    const WeldFigure* known = findImperfection(item.name);
    return item.state == VerdictState::notResolved && known != nullptr && !known->isMeasured();
}

/// The state as a word.
const std::string& stateText(const VerdictItem& item) {
    if (item.state == VerdictState::estimated)
        return phrase(item.beyond ? "judgement.state.likely" : "judgement.state.unlikely");
    if (isNotSimulated(item)) return phrase("judgement.state.not_simulated");
    return phraseOf("judgement.state", nameOf(item.state));
}

/// Adds to a failed item the sentence on how its imperfection is measured.
void addNote(const VerdictItem& item, JudgementRow& row) {
    const WeldFigure* known = findImperfection(item.name);
    if (item.state != VerdictState::fail || known == nullptr || known->note().empty()) return;
    row.detail.append(". ").append(known->note());
}

JudgementRow verdictRow(const VerdictItem& item) {
    JudgementRow row{capitalised(imperfectionName(item.name)), stateText(item), {}, RowState::open};
    if (item.state == VerdictState::pass) row.state = RowState::good;
    if (item.state == VerdictState::fail) row.state = RowState::bad;
    if (item.state == VerdictState::estimated) {
        row.detail = phrase(item.beyond ? "judgement.item.likely" : "judgement.item.unlikely",
                            {{"length", rounded(item.value.value_or(0), 0)}, {"rule", item.rule}});
        return row;
    }
    if (isNotSimulated(item)) {
        row.detail = capitalised(limitText(item));
        return row;
    }
    const std::string value = item.value ? valueText(item) : phrase("judgement.item.not_measured");
    const bool placed = item.place && item.state != VerdictState::pass && item.meanOver == 0;
    row.detail =
        phrase(placed ? "judgement.item.value_at" : "judgement.item.value",
               {{"value", value}, {"limit", limitText(item)}, {"place", rounded(item.place.value_or(0) * 1e3, 0)}});
    addNote(item, row);
    return row;
}

constexpr int kRanks = 5;

/// Rank of a row: failed first, passed last.
int rankOf(const VerdictItem& item) {
    switch (item.state) {
    case VerdictState::fail:
        return 0;
    case VerdictState::notResolved:
        return isNotSimulated(item) ? 2 : 1;
    case VerdictState::estimated:
        return 3;
    case VerdictState::pass:
        break;
    }
    return 4;
}

/// Count of states: "1 failed, 4 passed, 2 too fine to see, 3 not simulated", by rankOf().
std::string countText(const std::array<int, kRanks>& counts) {
    std::string text;
    const auto add = [&](std::string_view key, int count) {
        if (!text.empty()) text += phrase("list.separator");
        text += phraseOfCount(key, count, {{"count", PhraseNumber(count)}});
    };
    add("judgement.count.fail", counts[0]);
    add("judgement.count.pass", counts[4]);
    if (counts[1] > 0) add("judgement.count.not_resolved", counts[1]);
    if (counts[2] > 0) add("judgement.count.not_simulated", counts[2]);
    if (counts[3] > 0) add("judgement.count.estimated", counts[3]);
    return text;
}

std::string verdictNote(const Verdict& verdict) {
    std::array<int, kRanks> counts{};
    for (const VerdictItem& item : verdict.items)
        ++counts[static_cast<size_t>(rankOf(item))];
    return phrase("judgement.standard.note",
                  {{"edition", verdict.edition}, {"level", verdict.level}, {"counts", countText(counts)}});
}

/// Text of the failures: "Fails: overlap, undercut."; if nothing fails, how much was judged and how much was not.
std::string failedText(const Verdict& verdict) {
    std::string names;
    for (const VerdictItem& item : verdict.items) {
        if (item.state != VerdictState::fail) continue;
        if (!names.empty()) names += phrase("list.separator");
        names += capitalised(imperfectionName(item.name));
    }
    if (!names.empty()) return phrase("judgement.verdict.fails", {{"imperfections", names}});
    if (!verdict.accepted) return {};
    const size_t open = verdict.notAssessed();
    return phrase("judgement.verdict.nothing",
                  {{"passed", std::to_string(verdict.items.size() - open)}, {"count", std::to_string(open)}});
}

void addVerdict(JudgementRows& rows, const Judgement& judgement) {
    if (!judgement.verdict) {
        const bool welded = judgement.weld && !judgement.weld->stations.empty();
        rows.verdict = phrase(welded ? "judgement.verdict.not_judged" : "judgement.verdict.no_weld");
        rows.judged.title = phrase("judgement.standard.heading_without");
        rows.judged.note = phrase(welded ? "judgement.standard.none" : "judgement.standard.no_weld");
        return;
    }
    const Verdict& verdict = *judgement.verdict;
    rows.verdict = phrase(verdict.accepted ? "judgement.verdict.accepted" : "judgement.verdict.not_accepted",
                          {{"standard", verdict.standard}, {"level", verdict.level}});
    rows.verdictState = verdict.accepted ? RowState::good : RowState::bad;
    rows.judged.title = phrase("judgement.standard.heading", {{"standard", verdict.standard}});
    rows.judged.note = verdictNote(verdict);
    rows.verdictNote = failedText(verdict);
    if (!verdict.complete) {
        const std::string unfinished =
            phrase("judgement.verdict.unfinished", {{"judged", rounded(verdict.judgedLength * 1e3, 0)},
                                                    {"asked", rounded(verdict.askedLength * 1e3, 0)}});
        rows.verdictNote = rows.verdictNote.empty() ? unfinished : unfinished + " " + rows.verdictNote;
    }
    std::vector<VerdictItem> items = verdict.items;
    std::stable_sort(items.begin(), items.end(),
                     [](const VerdictItem& a, const VerdictItem& b) { return rankOf(a) < rankOf(b); });
    for (const VerdictItem& item : items)
        rows.judged.rows.push_back(verdictRow(item));
}

void addCures(JudgementRows& rows, const Judgement& judgement) {
    for (const Cure& cure : judgement.cures) {
        const bool known = std::any_of(rows.cures.begin(), rows.cures.end(),
                                       [&](const CureRow& above) { return above.whatIf == cure.whatIf; });
        rows.cures.push_back(known ? CureRow{cure.sentence, {}, {}} : CureRow{cure.sentence, cure.whatIf, cure.change});
    }
}

using Member = WeldStation::Value WeldStation::*;

/// Figures for a trainee, in this order.
constexpr std::array<Member, 4> kFilletFigures{&WeldStation::throat, &WeldStation::leg1, &WeldStation::leg2,
                                               &WeldStation::convexity};
constexpr std::array<Member, 3> kBeadFigures{&WeldStation::toeWidth, &WeldStation::height,
                                             &WeldStation::excessPenetration};
constexpr std::array<Member, 4> kCommonFigures{&WeldStation::fusedWidth, &WeldStation::penetration,
                                               &WeldStation::hazWidth, &WeldStation::coolingTime};

std::string panelName(Member member) {
    return capitalised(stationFigure(member).panelWords());
}

/// Text of a value in SI: "4.3 mm".
std::string figureText(const WeldFigure& figure, double value) {
    return withUnit(rounded(value / figure.inSi(), figure.digits), figure.unit);
}

void addFigures(std::vector<JudgementRow>& rows, const WeldMeasures& weld, std::span<const Member> members) {
    for (const Member member : members) {
        const WeldStation::Value& value = weld.mean.*member;
        const bool isBeadWidth = member == &WeldStation::toeWidth && weld.kind != WeldKind::fillet;
        if (!value && !isBeadWidth) continue;
        if (isBeadWidth && value.value_or(0) <= 0) { // a weld without toes
            rows.push_back({panelName(member), phrase("judgement.measured.absent"), {}, RowState::plain});
            continue;
        }
        const WeldFigure& figure = stationFigure(member);
        std::string range;
        const WeldStation::Value &least = weld.least.*member, &greatest = weld.greatest.*member;
        if (least && greatest)
            range = phrase("judgement.measured.range",
                           {{"least", inShownUnit(rounded(*least / figure.inSi(), figure.digits), figure.unit)},
                            {"greatest", figureText(figure, *greatest)}});
        rows.push_back({panelName(member), figureText(figure, *value), std::move(range), RowState::plain});
    }
}

/// Adds a row with a share of the seam's length.
void addShare(std::vector<JudgementRow>& rows, const WeldMeasures& weld, Member member, std::string name) {
    if (const WeldStation::Value& share = weld.mean.*member)
        rows.push_back({std::move(name), figureText(stationFigure(member), *share), phrase("judgement.measured.share"),
                        RowState::plain});
}

void addMeasures(JudgementRows& rows, const Judgement& judgement) {
    rows.measured.title = phrase("judgement.measured.heading");
    if (!judgement.weld || judgement.weld->stations.empty()) {
        rows.measured.note = phrase("judgement.measured.none");
        return;
    }
    const WeldMeasures& weld = *judgement.weld;
    rows.measured.note = phrase("judgement.measured.note", {{"length", rounded(weld.length() * 1e3, 0)},
                                                            {"count", PhraseNumber(double(weld.stations.size()))},
                                                            {"spacing", rounded(weld.spacing * 1e3, 1)}});
    std::vector<JudgementRow>& list = rows.measured.rows;
    if (weld.kind == WeldKind::fillet)
        addFigures(list, weld, kFilletFigures);
    else
        addFigures(list, weld, kBeadFigures);
    addFigures(list, weld, kCommonFigures);
    addShare(list, weld, &WeldStation::rootFused, panelName(&WeldStation::rootFused));
    addShare(list, weld, &WeldStation::facesFused,
             weld.kind == WeldKind::bead ? phrase("judgement.measured.plate_fused")
                                         : panelName(&WeldStation::facesFused));
    if (!weld.mean.coolingTime)
        list.push_back({panelName(&WeldStation::coolingTime), phrase("judgement.measured.unknown"),
                        phrase("judgement.measured.when_cooled"), RowState::plain});
    for (const WeldFigure& figure : wholeWeldFigures())
        if (figure.whole != nullptr && weld.*figure.whole)
            list.push_back(
                {capitalised(figure.panelWords()), figureText(figure, *(weld.*figure.whole)), {}, RowState::plain});
}

} // namespace

JudgementRows judgementRows(const Judgement& judgement, const TechniqueBands* bands, const QuantitySet& held) {
    JudgementRows rows;
    addTechnique(rows, judgement, bands, held);
    for (const Correction& correction : judgement.corrections)
        rows.corrections.push_back(correction.sentence);
    addVerdict(rows, judgement);
    addCures(rows, judgement);
    addMeasures(rows, judgement);
    return rows;
}

} // namespace meltpool
