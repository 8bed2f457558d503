// A curve along the seam with the band that the lesson asks for, as an SVG drawing.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace meltpool {

struct CurveBand {
    double ideal = 0;
    double inner = 0; ///< half width with full points
    double outer = 0; ///< half width where points end
};

struct Curve {
    std::string title;
    std::string unit;
    std::vector<double> places; ///< mm along the seam, ascending
    std::vector<double> values; ///< as many; NaN where nothing is known: the curve is broken there
    std::optional<CurveBand> band;
};

/// The text as HTML and SVG show it: &, <, > and quotes escaped, control characters left out.
std::string escaped(const std::string& text);

/// Round numbers between two ends, some `about` of them.
std::vector<double> ticks(double from, double to, int about);

/// An <svg> element of 640 x 130 units. Nothing to draw (no finite value): an empty text.
std::string curveDrawing(const Curve& curve);

} // namespace meltpool
