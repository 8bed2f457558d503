#include "app/report/curve_drawing.hpp"

#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <cmath>
#include <string_view>

namespace meltpool {

namespace {

constexpr double kLeft = 36, kRight = 6, kTop = 17, kBottom = 18;

std::string tickText(double value) {
    return withDecimalMark(formatNumber(static_cast<float>(value)));
}

/// Draws round numbers of one system along an axis; `scale` leads to millimetres and back.
template <class Draw>
void drawTicks(const CurveRange& range, int about, double scale, const Draw& draw) {
    const CurveTicks ticks = curveTicks({range.from * scale, range.to * scale}, about);
    for (int k = 0; k < ticks.count; ++k)
        draw(ticks.at(k) / scale, tickText(std::abs(ticks.at(k)) < 1e-9 * ticks.step ? 0 : ticks.at(k)));
}

class Drawing {
  public:
    Drawing(const Curve& curve, const CurveSheet& sheet)
        : curve_(curve),
          sheet_(sheet),
          svg_(kCurveWidth, kCurveHeight, phrase("drawing.curve.label", {{"quantity", curve.title}})) {}

    std::string element() {
        band();
        axes();
        lines();
        title();
        return svg_.element();
    }

  private:
    void band() {
        if (!curve_.band) return;
        const CurveBand& band = *curve_.band;
        const auto strip = [&](double half, std::string_view style) {
            svg_.rectangle(sheet_.left, sheet_.y(band.ideal + half), sheet_.right, sheet_.y(band.ideal - half), style);
        };
        strip(band.outer, "outer");
        strip(band.inner, "inner");
        for (const double side : {-1.0, 1.0}) {
            const double y = sheet_.y(band.ideal + side * band.outer);
            svg_.line(sheet_.left, y, sheet_.right, y, "limit");
        }
        svg_.line(sheet_.left, sheet_.y(band.ideal), sheet_.right, sheet_.y(band.ideal), "ideal");
    }

    void axes() {
        const ShownUnit inches = inchUnit(curve_.unit);
        const bool both = inches.converts();
        ticksOfValues(1, both ? "mm" : "");
        if (both) ticksOfValues(inches.perMetric, "in");
        ticksOfPlaces(1, "mm");
        ticksOfPlaces(inchUnit("mm").perMetric, "in");
        svg_.line(sheet_.left, sheet_.top, sheet_.left, sheet_.bottom, "axis");
        svg_.line(sheet_.left, sheet_.bottom, sheet_.right, sheet_.bottom, "axis");
    }

    void ticksOfValues(double scale, std::string_view system) {
        drawTicks(sheet_.values, 3, scale, [&](double value, const std::string& text) {
            svg_.word(sheet_.left - 4, sheet_.y(value) + 3, "end", text, system);
        });
    }

    void ticksOfPlaces(double scale, std::string_view system) {
        drawTicks(sheet_.places, 6, scale, [&](double place, const std::string& text) {
            const double x = sheet_.x(place);
            svg_.line(x, sheet_.bottom, x, sheet_.bottom + 3, "axis " + std::string(system));
            svg_.word(x, sheet_.bottom + 12, "middle", text, system);
        });
    }

    /// Draws the curve, with gaps where values are unknown; a single point is a short line, so that it is visible.
    void lines() {
        std::string points;
        size_t count = 0;
        double lastX = 0, lastY = 0, lastPlace = 0;
        const auto finish = [&] {
            if (count == 1) points += " " + SvgText::point(lastX + 1, lastY);
            if (count > 0) svg_.polyline(points, "curve");
            points.clear();
            count = 0;
        };
        for (size_t i = 0; i < curve_.places.size(); ++i) {
            const double place = curve_.places[i], value = curve_.values[i];
            if (!std::isfinite(value) || !std::isfinite(place)) {
                finish();
                continue;
            }
            if (count > 0 && place - lastPlace > kCurveGap) finish();
            lastPlace = place;
            lastX = sheet_.x(place);
            lastY = sheet_.y(value);
            points += (count++ > 0 ? " " : "") + SvgText::point(lastX, lastY);
        }
        finish();
    }

    void title() {
        const auto text = [&](std::string_view key, std::string_view unit, std::string_view style) {
            svg_.word(4, 10, "start", phrase(key, {{"quantity", curve_.title}, {"unit", unit}}), style);
        };
        text("drawing.curve.over_mm", curve_.unit, "title mm");
        text("drawing.curve.over_inches", inchUnit(curve_.unit).name, "title in");
    }

    const Curve& curve_;
    const CurveSheet& sheet_;
    SvgText svg_;
};

} // namespace

CurveSheet sheetOf(const Curve& curve) {
    CurveSheet sheet{kLeft, kTop, kCurveWidth - kRight, kCurveHeight - kBottom, {}, {}};
    if (curve.places.size() != curve.values.size()) return sheet;
    CurveRange values;
    for (size_t i = 0; i < curve.places.size(); ++i) {
        sheet.places.take(curve.places[i]);
        values.take(curve.values[i]);
    }
    sheet.values = shownRange(values, curve.band);
    return sheet;
}

std::string curveDrawing(const Curve& curve) {
    const CurveSheet sheet = sheetOf(curve);
    if (sheet.places.empty() || sheet.values.empty()) return {};
    return Drawing(curve, sheet).element();
}

} // namespace meltpool
