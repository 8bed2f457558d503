// A curve along the seam with the band that the lesson asks for, as an SVG drawing.
#pragma once

#include "app/report/curve_scale.hpp"
#include "app/report/svg_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace meltpool {

struct Curve {
    std::string title;
    std::string unit;           ///< "mm" and "mm/s" are shown in inches too, of which the page shows one
    std::vector<double> places; ///< mm along the seam, ascending
    std::vector<double> values; ///< as many as `places`; NaN if unknown: the curve has a gap there
    std::optional<CurveBand> band;
};

/// Size of a curve's drawing, in its units.
inline constexpr double kCurveWidth = 320, kCurveHeight = 92;

/// Sheet of the curve in its drawing; an empty range of values if there is nothing to draw. Two places farther apart
/// than this, mm, are not joined.
CurveSheet sheetOf(const Curve& curve);
inline constexpr double kCurveGap = 1.5;

/// <svg> element of kCurveWidth x kCurveHeight. Nothing to draw (no finite value): an empty text.
std::string curveDrawing(const Curve& curve);

} // namespace meltpool
