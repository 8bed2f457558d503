#include "app/report/curve_drawing.hpp"

#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace meltpool {

namespace {

constexpr double kWidth = 640, kHeight = 130;
constexpr double kLeft = 48, kRight = 8, kTop = 22, kBottom = 24;

struct Range {
    double from = std::numeric_limits<double>::infinity();
    double to = -std::numeric_limits<double>::infinity();

    void take(double value) {
        if (!std::isfinite(value)) return;
        from = std::min(from, value);
        to = std::max(to, value);
    }
    bool empty() const { return from > to; }
    double share(double value) const { return to > from ? (value - from) / (to - from) : 0.5; }
};

std::string coordinate(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

/// Draws into the area between the axes.
class Sheet {
  public:
    Sheet(const Range& places, const Range& values) : places_(places), values_(values) {}

    double x(double place) const { return kLeft + places_.share(place) * (kWidth - kLeft - kRight); }
    double y(double value) const { return kHeight - kBottom - values_.share(value) * (kHeight - kTop - kBottom); }

    void strip(double from, double to, const char* style) {
        const double top = y(std::min(to, values_.to)), bottom = y(std::max(from, values_.from));
        if (bottom <= top) return;
        text_ += "<rect class=\"" + std::string(style) + "\" x=\"" + coordinate(kLeft) + "\" y=\"" + coordinate(top) +
                 "\" width=\"" + coordinate(kWidth - kLeft - kRight) + "\" height=\"" + coordinate(bottom - top) +
                 "\"/>";
    }
    void line(double x1, double y1, double x2, double y2, const char* style) {
        text_ += "<line class=\"" + std::string(style) + "\" x1=\"" + coordinate(x1) + "\" y1=\"" + coordinate(y1) +
                 "\" x2=\"" + coordinate(x2) + "\" y2=\"" + coordinate(y2) + "\"/>";
    }
    void word(double x, double y, const char* anchor, const std::string& word) {
        text_ += "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" text-anchor=\"" + anchor + "\">" +
                 escaped(word) + "</text>";
    }
    /// A point in a curve of one point too is seen.
    void curve(const std::vector<double>& places, const std::vector<double>& values) {
        std::string points;
        const auto finish = [&] {
            if (!points.empty()) text_ += "<polyline class=\"curve\" points=\"" + points + "\"/>";
            points.clear();
        };
        for (size_t i = 0; i < places.size(); ++i) {
            if (!std::isfinite(values[i])) {
                finish();
                continue;
            }
            const std::string point = coordinate(x(places[i])) + "," + coordinate(y(values[i]));
            points += points.empty() ? point + " " + point : " " + point;
        }
        finish();
    }
    const std::string& text() const { return text_; }

  private:
    const Range& places_;
    const Range& values_;
    std::string text_;
};

/// All values and the whole band, with some air; one that wanders far off shows at most three outer widths.
Range shownValues(const Curve& curve) {
    Range range;
    for (const double value : curve.values)
        range.take(value);
    if (range.empty() || !curve.band) return range;
    const CurveBand& band = *curve.band;
    const double far = 3 * std::max(band.outer, 1e-6);
    range.from = std::clamp(range.from, band.ideal - far, band.ideal - 1.1 * band.outer);
    range.to = std::clamp(range.to, band.ideal + 1.1 * band.outer, band.ideal + far);
    return range;
}

} // namespace

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '"')
            safe += "&quot;";
        else if (static_cast<unsigned char>(c) >= 0x20)
            safe += c;
    }
    return safe;
}

std::vector<double> ticks(double from, double to, int about) {
    if (!(to > from) || about < 1) return {};
    const double rough = (to - from) / about, power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= rough) step = factor * power;
    std::vector<double> places;
    for (double k = std::ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k)
        places.push_back(k * step);
    return places;
}

std::string curveDrawing(const Curve& curve) {
    const Range values = shownValues(curve);
    Range places;
    for (const double place : curve.places)
        places.take(place);
    if (values.empty() || places.empty() || curve.places.size() != curve.values.size()) return {};
    Sheet sheet(places, values);
    if (curve.band) {
        sheet.strip(curve.band->ideal - curve.band->outer, curve.band->ideal + curve.band->outer, "outer");
        sheet.strip(curve.band->ideal - curve.band->inner, curve.band->ideal + curve.band->inner, "inner");
        sheet.line(kLeft, sheet.y(curve.band->ideal), kWidth - kRight, sheet.y(curve.band->ideal), "ideal");
    }
    for (const double tick : ticks(values.from, values.to, 4))
        sheet.word(kLeft - 5, sheet.y(tick) + 3, "end", formatNumber(static_cast<float>(tick)));
    for (const double tick : ticks(places.from, places.to, 8)) {
        sheet.line(sheet.x(tick), kHeight - kBottom, sheet.x(tick), kHeight - kBottom + 4, "axis");
        sheet.word(sheet.x(tick), kHeight - kBottom + 15, "middle", formatNumber(static_cast<float>(tick)));
    }
    sheet.line(kLeft, kTop, kLeft, kHeight - kBottom, "axis");
    sheet.line(kLeft, kHeight - kBottom, kWidth - kRight, kHeight - kBottom, "axis");
    std::vector<double> shown = curve.values;
    for (double& value : shown)
        if (std::isfinite(value)) value = std::clamp(value, values.from, values.to);
    sheet.curve(curve.places, shown);
    sheet.word(kLeft, 14, "start", curve.title + " (" + curve.unit + ") along the seam (mm)");
    return "<svg viewBox=\"0 0 640 130\" role=\"img\" aria-label=\"" + escaped(curve.title) + "\">" + sheet.text() +
           "</svg>\n";
}

} // namespace meltpool
