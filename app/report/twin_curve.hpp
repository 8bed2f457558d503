// One quantity of two attempts along the seam, in one SVG drawing.
#pragma once

#include "app/report/curve_drawing.hpp"

namespace meltpool {

/// <svg> element of 640 x 130 units: the first attempt's curve dashed, the second's solid, so that they differ in grey
/// too, over the band of `first` if it has one. Title and unit are those of `first`. Nothing to draw (no finite value):
/// an empty text.
std::string twinCurveDrawing(const Curve& first, const Curve& second);

} // namespace meltpool
