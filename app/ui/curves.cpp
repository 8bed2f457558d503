// Draws curves along the seam of the judged attempt, with the lesson's bands, equal to those on its page.
#include "app/ui/curves.hpp"

#include "app/ui/panels.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool::ui {

namespace {

constexpr ImU32 kInner = IM_COL32(134, 214, 140, 46);
constexpr ImU32 kOuter = IM_COL32(255, 203, 87, 26);
constexpr ImU32 kIdeal = IM_COL32(134, 214, 140, 190);
constexpr ImU32 kAxis = IM_COL32(255, 255, 255, 60);

constexpr float kTitle = 18, kFoot = 16, kMargin = 40; ///< points
constexpr double kGap = 1.5;                           ///< mm of seam without arc that break the line

/// Value of a curve at each millimetre, NaN if unknown.
using SeamValue = FunctionRef<double(const SeamMillimetre&)>;

struct CurveWords {
    std::string_view key, title, unit;
};

ImVec2 at(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

CurveSheet sheetAt(ImVec2 corner, ImVec2 size, const Context& context, const CurveChart& chart,
                   std::span<const CurveSeries> series) {
    CurveSheet sheet;
    sheet.left = static_cast<double>(corner.x + context.points(kMargin));
    sheet.right = static_cast<double>(corner.x + size.x - context.points(4));
    sheet.top = static_cast<double>(corner.y + context.points(kTitle));
    sheet.bottom = static_cast<double>(corner.y + size.y - context.points(kFoot));
    sheet.places = chart.places;
    CurveRange values;
    for (const CurveSeries& each : series)
        for (size_t i = 0; i < each.count; ++i) {
            sheet.places.take(each.place(i));
            values.take(each.value(i));
        }
    if (values.empty() && chart.band && !chart.places.empty()) values.take(chart.band->ideal);
    sheet.values = shownRange(values, chart.band);
    return sheet;
}

void drawBand(ImDrawList& draw, const CurveSheet& sheet, const CurveBand& band) {
    const auto strip = [&](double half, ImU32 tint) {
        fillRounded(draw, at(sheet.left, sheet.y(band.ideal + half)), at(sheet.right, sheet.y(band.ideal - half)), tint,
                    0);
    };
    strip(band.outer, kOuter);
    strip(band.inner, kInner);
    const double y = sheet.y(band.ideal);
    draw.AddLine(at(sheet.left, y), at(sheet.right, y), kIdeal);
}

/// Ends of a range in a shown unit.
CurveRange inUnit(const CurveRange& range, const ShownUnit& unit) {
    return {range.from * unit.perMetric, range.to * unit.perMetric};
}

void drawAxes(Context& context, ImDrawList& draw, const CurveSheet& sheet, const CurveChart& chart) {
    const ShownUnit valueUnit = shownUnit(chart.unit), placeUnit = shownUnit(chart.placeUnit);
    draw.AddLine(at(sheet.left, sheet.top), at(sheet.left, sheet.bottom), kAxis);
    draw.AddLine(at(sheet.left, sheet.bottom), at(sheet.right, sheet.bottom), kAxis);
    const double half = static_cast<double>(ImGui::GetTextLineHeight()) / 2,
                 gap = static_cast<double>(context.points(5));
    const bool high = sheet.bottom - sheet.top >= static_cast<double>(context.points(64));
    const CurveTicks values = curveTicks(inUnit(sheet.values, valueUnit), high ? 4 : 3);
    for (int k = 0; k < values.count; ++k) {
        const ShortText text = niceNumber(values.at(k));
        const double width = static_cast<double>(ImGui::CalcTextSize(text.c_str()).x);
        draw.AddText(at(sheet.left - gap - width, sheet.y(values.at(k) / valueUnit.perMetric) - half), colour::kQuiet,
                     text.c_str());
    }
    const CurveTicks places = curveTicks(inUnit(sheet.places, placeUnit), 5);
    for (int k = 0; k < places.count; ++k) {
        const ShortText number = niceNumber(places.at(k));
        const bool last = k + 1 == places.count; // it has the unit
        const ShortText text = last ? ShortText{number, " ", placeUnit.name} : number;
        const double width = static_cast<double>(ImGui::CalcTextSize(text.c_str()).x),
                     x = sheet.x(places.at(k) / placeUnit.perMetric);
        const double most = sheet.right - width;
        draw.AddLine(at(x, sheet.bottom), at(x, sheet.bottom + gap / 2), kAxis);
        draw.AddText(at(std::min(x - width / 2, most), sheet.bottom + gap / 2), colour::kQuiet, text.c_str());
    }
}

/// Draws a line, broken at unknown stretches longer than its gap.
void drawLine(Context& context, ImDrawList& draw, const CurveSheet& sheet, const CurveSeries& series) {
    const float thick = context.points(1.6f);
    bool begun = false;
    double before = 0;
    ImVec2 from{};
    for (size_t i = 0; i < series.count; ++i) {
        const double value = series.value(i), place = series.place(i);
        if (!std::isfinite(value)) continue;
        const ImVec2 point = at(sheet.x(place), sheet.y(value));
        if (begun && place - before <= series.gap)
            draw.AddLine(from, point, series.tint, thick);
        else
            draw.AddCircleFilled(point, thick, series.tint, 8);
        begun = true;
        before = place;
        from = point;
    }
}

/// Finds the point with a value that is nearest to a place; empty if there is none.
std::optional<size_t> nearest(const CurveSeries& series, double place) {
    std::optional<size_t> found;
    double least = 0;
    for (size_t i = 0; i < series.count; ++i) {
        const double distance = std::abs(series.place(i) - place);
        if (!std::isfinite(series.value(i)) || (found && distance >= least)) continue;
        found = i;
        least = distance;
    }
    return found;
}

/// True if one of the curves has a value at this place, or within its gap.
bool knownAt(std::span<const CurveSeries> series, double place) {
    return std::any_of(series.begin(), series.end(), [place](const CurveSeries& each) {
        const auto point = nearest(each, place);
        return point && std::abs(each.place(*point) - place) <= each.gap;
    });
}

/// Writes two or three digits behind the point, as the number's size needs.
ShortText pointedNumber(double value) {
    const double scale = std::abs(value) < 10 ? 100 : 10;
    return niceNumber(std::round(value * scale) / scale);
}

/// Draws the place under the pointer and each curve's value there, at the right of the title.
void drawPointed(Context& context, ImDrawList& draw, const CurveChart& chart, std::span<const CurveSeries> series,
                 const CurveSheet& sheet, double under, float top) {
    std::optional<double> place;
    ShortText values;
    for (const CurveSeries& each : series) {
        const std::optional<size_t> point = nearest(each, place.value_or(under));
        if (!place && point) place = each.place(*point);
        values += values.empty() ? "" : " / ";
        values += point ? pointedNumber(each.value(*point)) : ShortText("-");
    }
    if (!place) return;
    curveMark(context, sheet, *place, colour::kAccent);
    ShortText text;
    appendPhrase(text, "curve.pointed",
                 {{"values", values},
                  {"unit", chart.unit},
                  {"place", niceNumber(std::round(*place * 10) / 10)},
                  {"place_unit", chart.placeUnit}});
    draw.AddText({static_cast<float>(sheet.right) - ImGui::CalcTextSize(text.c_str()).x, top}, colour::kAccent,
                 text.c_str());
}

void drawSeam(Context& context, const std::vector<SeamMillimetre>& seam, const CurveWords& words, SeamValue value,
              const std::optional<CurveBand>& band) {
    const auto place = [&](size_t i) { return seam[i].place * 1e3; };
    const auto number = [&](size_t i) { return value(seam[i]); };
    const std::array<CurveSeries, 1> series{{{seam.size(), place, number, kGap}}};
    const ShortText name{"result.curve.", words.key};
    curveChart(context, {name, words.title, words.unit, "mm", band}, series);
}

void drawQuantity(Context& context, const Judgement& judgement, TechniqueQuantity quantity, const TechniqueBand* band) {
    const QuantityInfo& info = quantityInfo(quantity, judgement.distance);
    std::optional<CurveBand> asked;
    if (band != nullptr) asked = CurveBand{band->ideal, band->inner, band->outer};
    drawSeam(
        context, judgement.seam, {info.column, info.words(), info.unit},
        [&](const SeamMillimetre& mm) { return mm.values[quantity] * info.perSi; }, asked);
}

/// Curves of lessons that judge no technique: the quantities that guide every weld.
constexpr std::array kPlain{TechniqueQuantity::travelSpeed, TechniqueQuantity::workAngle,
                            TechniqueQuantity::travelAngle, TechniqueQuantity::distance, TechniqueQuantity::aim};

} // namespace

CurveAnswer curveChart(Context& context, const CurveChart& chart, std::span<const CurveSeries> series) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, context.points(2 * kMargin)),
                      context.points(chart.height)};
    CurveAnswer answer;
    answer.sheet = sheetAt(corner, size, context, chart, series);
    const CurveSheet& sheet = answer.sheet;
    answer.drawn = !sheet.places.empty() && (!sheet.values.empty() || !chart.places.empty());
    if (!answer.drawn) return answer;
    answer.clicked = ImGui::InvisibleButton(ShortText(chart.name).c_str(), size) && ImGui::IsMouseReleased(0);
    answer.hovered = ImGui::IsItemHovered();
    markItem(context, chart.name);
    const double share = (static_cast<double>(ImGui::GetIO().MousePos.x) - sheet.left) / (sheet.right - sheet.left);
    answer.under = sheet.places.from + std::clamp(share, 0.0, 1.0) * (sheet.places.to - sheet.places.from);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ShortText title;
    appendPhrase(title, "curve.title", {{"quantity", chart.title}, {"unit", chart.unit}});
    draw.AddText(corner, colour::kText, title.c_str());
    if (chart.band && !sheet.values.empty()) drawBand(draw, sheet, *chart.band);
    drawAxes(context, draw, sheet, chart);
    for (const CurveSeries& each : series)
        drawLine(context, draw, sheet, each);
    if (answer.hovered)
        drawPointed(context, draw, chart, series, sheet, answer.under, corner.y);
    else if (chart.cursor && knownAt(series, *chart.cursor))
        drawPointed(context, draw, chart, series, sheet, *chart.cursor, corner.y);
    return answer;
}

void curveMark(Context& context, const CurveSheet& sheet, double place, ImU32 tint, float thickness) {
    const double x = sheet.x(std::clamp(place, sheet.places.from, sheet.places.to));
    ImGui::GetWindowDrawList()->AddLine(at(x, sheet.top), at(x, sheet.bottom), tint, context.points(thickness));
}

void curvesPart(Context& context, const Judgement& judgement, const TechniqueBands* bands) {
    if (judgement.seam.empty() || !groupHeading(context, "result", "Along the seam", false)) return;
    ImGui::PushFont(context.fonts.small);
    if (bands != nullptr)
        for (const TechniqueBand& band : bands->bands)
            drawQuantity(context, judgement, band.quantity, &band);
    else
        for (const TechniqueQuantity quantity : kPlain)
            drawQuantity(context, judgement, quantity, nullptr);
    if (judgement.arc.charge > 0) {
        drawSeam(context, judgement.seam, {"current_a", phrase("curve.current"), "A"},
                 [](const SeamMillimetre& mm) { return mm.current; }, {});
        drawSeam(context, judgement.seam, {"voltage_v", phrase("curve.voltage"), "V"},
                 [](const SeamMillimetre& mm) { return mm.voltage; }, {});
    }
    ImGui::PopFont();
    if (bands != nullptr) quietText(context, phrase("curve.note", {}));
}

} // namespace meltpool::ui
