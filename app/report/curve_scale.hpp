// The scale of a curve's sheet, shared by the page and the panels of window and headset.
#pragma once

#include <limits>
#include <optional>

namespace meltpool {

/// Band of the lesson, in the curve's unit.
struct CurveBand {
    double ideal = 0;
    double inner = 0; ///< half width of full points
    double outer = 0; ///< half width at which points reach 0
};

/// Range of values; empty at first.
struct CurveRange {
    double from = std::numeric_limits<double>::infinity();
    double to = -std::numeric_limits<double>::infinity();

    /// Widens it by a value; no-op for one that is not finite.
    void take(double value);
    bool empty() const { return from > to; }
    /// Share of a value: 0 at `from`, 1 at `to`; the middle of a range that has no width.
    double share(double value) const { return to > from ? (value - from) / (to - from) : 0.5; }
};

/// Range of a curve's sheet: all values and the whole band with a tenth of it for air; a curve that goes far off shows
/// at most three outer half widths to either side.
CurveRange shownRange(const CurveRange& values, const std::optional<CurveBand>& band);

/// Round numbers within a range, some `about` of them: first + k step for k < count. None in an empty range or one
/// without width.
struct CurveTicks {
    double first = 0;
    double step = 0;
    int count = 0;

    double at(int k) const { return first + k * step; }
};
CurveTicks curveTicks(const CurveRange& range, int about);

/// Rectangle with axes, y growing downwards, in any unit.
struct CurveSheet {
    double left = 0, top = 0, right = 0, bottom = 0;
    CurveRange places; ///< mm along the seam
    CurveRange values; ///< in the curve's unit

    double x(double place) const { return left + places.share(place) * (right - left); }
    /// Place of a value in y; one beyond the range is at the edge.
    double y(double value) const;
};

} // namespace meltpool
