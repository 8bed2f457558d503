#include "app/activities/judgement_rows.hpp"

#include "core/base/text.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace meltpool {

namespace {

constexpr double kGood = 90; ///< points from which on a parameter is shown as good
constexpr double kBad = 70;  ///< and below which as bad

std::string rounded(double value, int digits) {
    const double scale = std::pow(10.0, digits);
    const double number = std::round(value * scale) / scale;
    return formatNumber(number == 0 ? 0.0 : number);
}

std::string capitalised(std::string_view words) {
    std::string text(words);
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

std::string withUnit(const std::string& number, std::string_view unit) {
    if (unit == "\xC2\xB0" || unit == "deg") return number + "\xC2\xB0";
    return number + " " + std::string(unit);
}

/// What a sign means; empty where it means more or less of the same.
std::string_view sideOf(TechniqueQuantity quantity, double value) {
    switch (quantity) {
    case TechniqueQuantity::aim:
        return value > 0 ? " to your side" : " to the far side";
    case TechniqueQuantity::workAngle:
        return value > 0 ? " towards you" : " away from you";
    case TechniqueQuantity::travelAngle:
        return value > 0 ? " push" : " drag";
    default:
        return {};
    }
}

/// "8\xC2\xB0 push", "0.4 mm to your side", "7.6 mm/s".
std::string valueText(const QuantityInfo& info, double value) {
    if (std::isnan(value)) return "not known";
    const std::string number = rounded(value, info.unit == "\xC2\xB0" ? 0 : 1);
    const std::string_view side = sideOf(info.quantity, value);
    if (number == "0" || side.empty()) return withUnit(number, info.unit);
    return withUnit(number[0] == '-' ? number.substr(1) : number, info.unit) + std::string(side);
}

JudgementRow techniqueRow(const ParameterScore& parameter, const TechniqueBand* band, DistanceKind distance) {
    const QuantityInfo& info = quantityInfo(parameter.quantity, distance);
    JudgementRow row{capitalised(info.words), rounded(parameter.score, 0) + " of 100",
                     "Mean " + valueText(info, parameter.mean), RowState::plain};
    if (band != nullptr)
        row.detail += "; asked for " + valueText(info, band->ideal) + ", give or take " +
                      withUnit(rounded(band->inner, 1), info.unit);
    if (parameter.score >= kGood) row.state = RowState::good;
    if (parameter.score < kBad) row.state = RowState::bad;
    return row;
}

void addTechnique(JudgementRows& rows, const Judgement& judgement, const TechniqueBands* bands) {
    rows.technique.title = "Your hand";
    if (!judgement.score) {
        rows.score = "No score";
        rows.scoreNote = "This lesson asks for no particular technique, so the hand has no score.";
        rows.technique.note = rows.scoreNote;
        return;
    }
    const TechniqueScore& score = *judgement.score;
    if (!score.scored) {
        rows.score = "Not scored";
        rows.scoreNote = score.reason;
        rows.technique.note = "Nothing was scored.";
        return;
    }
    rows.score = "Score " + rounded(score.total, 0) + " of 100";
    rows.scoreNote = rounded(score.weldedMm, 0) + " of " + rounded(score.wantedMm, 0) + " mm of the seam are welded.";
    if (score.unknownMm > 0) rows.scoreNote += " " + unknownSentence(score);
    for (const ParameterScore& parameter : score.parameters)
        rows.technique.rows.push_back(
            techniqueRow(parameter, bands == nullptr ? nullptr : bands->find(parameter.quantity), judgement.distance));
}

std::string limitText(const VerdictItem& item) {
    if (!item.limit) return "no limit";
    if (item.kind == LimitKind::notPermitted) return "none is allowed";
    return (item.kind == LimitKind::atLeast ? "at least " : "at most ") + withUnit(rounded(*item.limit, 1), item.unit);
}

/// The state as a word.
std::string stateText(const VerdictItem& item) {
    switch (item.state) {
    case VerdictState::pass:
        return "pass";
    case VerdictState::fail:
        return "FAIL";
    case VerdictState::estimated:
        return item.beyond ? "estimated: likely" : "estimated: unlikely";
    case VerdictState::notResolved:
        break;
    }
    return "not resolved";
}

/// What is to be said where the metal tells no value.
std::string unknownText(const VerdictItem& item) {
    const WeldFigure* known = findImperfection(item.name);
    const bool absent = known != nullptr && known->judged == nullptr;
    return absent ? "This metal cannot show it" : "Not measured on this weld";
}

JudgementRow verdictRow(const VerdictItem& item) {
    JudgementRow row{capitalised(imperfectionName(item.name)), stateText(item), {}, RowState::open};
    if (item.state == VerdictState::pass) row.state = RowState::good;
    if (item.state == VerdictState::fail) row.state = RowState::bad;
    if (item.state == VerdictState::estimated) {
        row.detail = "From your technique, not from the metal: ";
        row.detail += item.beyond ? rounded(item.value.value_or(0), 0) + " mm of the weld. " + item.rule
                                  : "nothing speaks for it.";
        return row;
    }
    row.detail = item.value ? withUnit(rounded(*item.value, 1), item.unit) : unknownText(item);
    row.detail += "; " + limitText(item);
    if (item.place && item.state != VerdictState::pass) row.detail += ", at " + rounded(*item.place * 1e3, 0) + " mm";
    return row;
}

/// Failed first, passed last.
int rankOf(VerdictState state) {
    switch (state) {
    case VerdictState::fail:
        return 0;
    case VerdictState::notResolved:
        return 1;
    case VerdictState::estimated:
        return 2;
    case VerdictState::pass:
        break;
    }
    return 3;
}

std::string countText(const Verdict& verdict) {
    std::array<int, 4> counts{};
    for (const VerdictItem& item : verdict.items)
        ++counts[static_cast<size_t>(rankOf(item.state))];
    std::string text = formatNumber(double(counts[0])) + " fail, " + formatNumber(double(counts[3])) + " pass";
    if (counts[1] > 0) text += ", " + formatNumber(double(counts[1])) + " are not resolved";
    if (counts[2] > 0)
        text += ", " + formatNumber(double(counts[2])) + (counts[2] == 1 ? " is" : " are") + " estimated";
    text += ".";
    if (counts[1] > 0)
        text += " Not resolved: finer than the particles of this metal, or nothing that it contains; it does not "
                "count either way.";
    if (counts[2] > 0)
        text += " Estimated: this metal contains no pores, spatter or slag, so your technique tells of them; that does "
                "not count either way.";
    return text;
}

/// "Fails: overlap, undercut."; empty where nothing fails.
std::string failedText(const Verdict& verdict) {
    std::string names;
    for (const VerdictItem& item : verdict.items)
        if (item.state == VerdictState::fail)
            names += (names.empty() ? "" : ", ") + capitalised(imperfectionName(item.name));
    return names.empty() ? names : "Fails: " + names + ".";
}

void addVerdict(JudgementRows& rows, const Judgement& judgement) {
    rows.judged.title = "The weld by a standard";
    if (!judgement.verdict) {
        const bool welded = judgement.weld && !judgement.weld->stations.empty();
        rows.verdict = welded ? "Measured, not judged" : "No weld to judge";
        rows.judged.note = welded ? "This lesson names no standard, so the weld is measured but not judged."
                                  : "There is no weld to judge yet.";
        return;
    }
    const Verdict& verdict = *judgement.verdict;
    rows.verdict = verdict.accepted ? "Accepted" : "Not accepted";
    rows.verdict += " by " + verdict.standard + ", level " + verdict.level;
    rows.verdictState = verdict.accepted ? RowState::good : RowState::bad;
    rows.judged.title = "The weld by " + verdict.standard;
    rows.judged.note = "Edition " + verdict.edition + ", level " + verdict.level + ": " + countText(verdict);
    rows.verdictNote = failedText(verdict);
    std::vector<VerdictItem> items = verdict.items;
    std::stable_sort(items.begin(), items.end(),
                     [](const VerdictItem& a, const VerdictItem& b) { return rankOf(a.state) < rankOf(b.state); });
    for (const VerdictItem& item : items)
        rows.judged.rows.push_back(verdictRow(item));
}

using Member = WeldStation::Value WeldStation::*;

/// The figures that a trainee reads, in this order.
constexpr std::array<Member, 4> kFilletFigures{&WeldStation::throat, &WeldStation::leg1, &WeldStation::leg2,
                                               &WeldStation::convexity};
constexpr std::array<Member, 3> kBeadFigures{&WeldStation::toeWidth, &WeldStation::height,
                                             &WeldStation::excessPenetration};
constexpr std::array<Member, 4> kCommonFigures{&WeldStation::fusedWidth, &WeldStation::penetration,
                                               &WeldStation::hazWidth, &WeldStation::coolingTime};

std::string panelName(Member member) {
    return capitalised(stationFigure(member).panelWords());
}

/// "4.3 mm" of a value in SI.
std::string figureText(const WeldFigure& figure, double value) {
    return withUnit(rounded(value / figure.inSi(), figure.digits), figure.unit);
}

void addFigures(std::vector<JudgementRow>& rows, const WeldMeasures& weld, std::span<const Member> members) {
    for (const Member member : members) {
        const WeldStation::Value& value = weld.mean.*member;
        if (!value) continue;
        const WeldFigure& figure = stationFigure(member);
        std::string range;
        const WeldStation::Value &least = weld.least.*member, &greatest = weld.greatest.*member;
        if (least && greatest)
            range = "From " + rounded(*least / figure.inSi(), figure.digits) + " to " + figureText(figure, *greatest);
        rows.push_back({panelName(member), figureText(figure, *value), std::move(range), RowState::plain});
    }
}

/// A share of the seam's length.
void addShare(std::vector<JudgementRow>& rows, const WeldMeasures& weld, Member member, std::string name) {
    if (const WeldStation::Value& share = weld.mean.*member)
        rows.push_back(
            {std::move(name), figureText(stationFigure(member), *share), "Of the seam's length", RowState::plain});
}

void addMeasures(JudgementRows& rows, const Judgement& judgement) {
    rows.measured.title = "The weld, measured";
    if (!judgement.weld || judgement.weld->stations.empty()) {
        rows.measured.note = "There is no weld to measure yet.";
        return;
    }
    const WeldMeasures& weld = *judgement.weld;
    rows.measured.note = "Means over " + rounded(weld.length() * 1e3, 0) + " mm of seam, cut at " +
                         formatNumber(double(weld.stations.size())) + " places; the particles are " +
                         rounded(weld.spacing * 1e3, 1) + " mm apart.";
    std::vector<JudgementRow>& list = rows.measured.rows;
    if (weld.kind == WeldKind::fillet)
        addFigures(list, weld, kFilletFigures);
    else
        addFigures(list, weld, kBeadFigures);
    addFigures(list, weld, kCommonFigures);
    addShare(list, weld, &WeldStation::rootFused, panelName(&WeldStation::rootFused));
    addShare(list, weld, &WeldStation::facesFused,
             weld.kind == WeldKind::bead ? "Plate fused" : panelName(&WeldStation::facesFused));
    if (!weld.mean.coolingTime)
        list.push_back({panelName(&WeldStation::coolingTime), "not known yet", "Judge again when the metal has cooled",
                        RowState::plain});
    for (const WeldFigure& figure : wholeWeldFigures())
        if (figure.whole != nullptr && weld.*figure.whole)
            list.push_back(
                {capitalised(figure.panelWords()), figureText(figure, *(weld.*figure.whole)), {}, RowState::plain});
}

} // namespace

JudgementRows judgementRows(const Judgement& judgement, const TechniqueBands* bands) {
    JudgementRows rows;
    addTechnique(rows, judgement, bands);
    for (const Correction& correction : judgement.corrections)
        rows.corrections.push_back(correction.sentence);
    addVerdict(rows, judgement);
    addMeasures(rows, judgement);
    return rows;
}

} // namespace meltpool
