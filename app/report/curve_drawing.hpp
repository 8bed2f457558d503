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
    std::vector<double> values; ///< as many; NaN where nothing is known: the curve is broken there
    std::optional<CurveBand> band;
};

/// Units of a curve's drawing.
inline constexpr double kCurveWidth = 320, kCurveHeight = 92;

/// Where the curve's points lie in its drawing; an empty range of values where there is nothing to draw. Two places
/// that are farther apart than this, mm, are not joined.
CurveSheet sheetOf(const Curve& curve);
inline constexpr double kCurveGap = 1.5;

/// An <svg> element of kCurveWidth x kCurveHeight. Nothing to draw (no finite value): an empty text.
std::string curveDrawing(const Curve& curve);

} // namespace meltpool
