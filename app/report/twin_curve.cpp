#include "app/report/twin_curve.hpp"

#include "app/report/svg_text.hpp"
#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace meltpool {

namespace {

constexpr double kWidth = 640, kHeight = 130;
constexpr double kLeft = 48, kRight = 8, kTop = 22, kBottom = 24;

ShownUnit metric(std::string_view unit) {
    return {unit == "mm2" ? std::string_view("mm\xC2\xB2") : unit};
}

/// Inch unit; the metric one for a unit that has no inches.
ShownUnit inches(std::string_view unit) {
    const ShownUnit inch = inchUnit(unit);
    return inch.converts() ? inch : metric(unit);
}

CurveSheet sheetOfBoth(const Curve& first, const Curve& second) {
    CurveSheet sheet{kLeft, kTop, kWidth - kRight, kHeight - kBottom, {}, {}};
    CurveRange values;
    for (const Curve* curve : {&first, &second}) {
        for (const double place : curve->places)
            sheet.places.take(place);
        for (const double value : curve->values)
            values.take(value);
    }
    // A value far off is shown at the edge, so that the band stays readable.
    sheet.values = shownRange(values, first.band);
    return sheet;
}

void drawBand(SvgText& svg, const CurveSheet& sheet, const CurveBand& band) {
    const auto strip = [&](double half, std::string_view style) {
        svg.rectangle(sheet.left, sheet.y(band.ideal + half), sheet.right, sheet.y(band.ideal - half), style);
    };
    strip(band.outer, "outer");
    strip(band.inner, "inner");
    svg.line(sheet.left, sheet.y(band.ideal), sheet.right, sheet.y(band.ideal), "ideal");
}

/// Draws round numbers of one system; `draw` gets the number in the curve's unit and as text.
template <class Draw>
void drawTicks(const CurveRange& range, int about, double per, const Draw& draw) {
    const CurveTicks ticks = curveTicks({range.from * per, range.to * per}, about);
    for (int k = 0; k < ticks.count; ++k) {
        const double value = std::abs(ticks.at(k)) < 1e-9 * ticks.step ? 0 : ticks.at(k);
        draw(value / per, withDecimalMark(formatNumber(static_cast<float>(value))));
    }
}

/// Draws numbers, title and axes in one system, whose name is the style that shows and hides it.
void drawSystem(SvgText& svg, const CurveSheet& sheet, const Curve& curve, std::string_view system) {
    const bool mm = system == "mm";
    const ShownUnit value = mm ? metric(curve.unit) : inches(curve.unit), place = mm ? metric("mm") : inches("mm");
    drawTicks(sheet.values, 4, value.perMetric, [&](double at, const std::string& text) {
        svg.word(sheet.left - 5, sheet.y(at) + 3, "end", text, system);
    });
    drawTicks(sheet.places, 8, place.perMetric, [&](double at, const std::string& text) {
        const double x = sheet.x(at);
        svg.line(x, sheet.bottom, x, sheet.bottom + 4, "axis " + std::string(system));
        svg.word(x, sheet.bottom + 15, "middle", text, system);
    });
    svg.word(sheet.left, 14, "start",
             phrase("drawing.twin.title", {{"quantity", curve.title}, {"unit", value.name}, {"length", place.name}}),
             system);
}

/// Draws one polyline for each stretch of known values; a single point is a short line, so that it is visible.
void drawLines(SvgText& svg, const CurveSheet& sheet, const Curve& curve, std::string_view style) {
    std::string points;
    const auto finish = [&] {
        if (!points.empty()) svg.polyline(points, style);
        points.clear();
    };
    for (size_t i = 0; i < std::min(curve.places.size(), curve.values.size()); ++i) {
        if (!std::isfinite(curve.values[i]) || !std::isfinite(curve.places[i])) {
            finish();
            continue;
        }
        const std::string point = SvgText::point(sheet.x(curve.places[i]), sheet.y(curve.values[i]));
        points += points.empty() ? point + " " + point : " " + point;
    }
    finish();
}

} // namespace

std::string twinCurveDrawing(const Curve& first, const Curve& second) {
    const CurveSheet sheet = sheetOfBoth(first, second);
    if (sheet.places.empty() || sheet.values.empty()) return {};
    SvgText svg(kWidth, kHeight, phrase("drawing.twin.label", {{"quantity", first.title}}));
    if (first.band) drawBand(svg, sheet, *first.band);
    drawSystem(svg, sheet, first, "mm");
    drawSystem(svg, sheet, first, "in");
    svg.line(sheet.left, sheet.top, sheet.left, sheet.bottom, "axis");
    svg.line(sheet.left, sheet.bottom, sheet.right, sheet.bottom, "axis");
    drawLines(svg, sheet, first, "first");
    drawLines(svg, sheet, second, "second");
    return svg.element();
}

} // namespace meltpool
