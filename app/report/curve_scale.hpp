// Where the points of a curve lie on its sheet: the same for the page and for the panels of window and headset.
#pragma once

#include <limits>
#include <optional>

namespace meltpool {

/// What a lesson asks for, in the curve's unit.
struct CurveBand {
    double ideal = 0;
    double inner = 0; ///< half width with full points
    double outer = 0; ///< half width where points end
};

/// A range of values; empty at first.
struct CurveRange {
    double from = std::numeric_limits<double>::infinity();
    double to = -std::numeric_limits<double>::infinity();

    /// Widens it by a value; one that is not finite changes nothing.
    void take(double value);
    bool empty() const { return from > to; }
    /// 0 at `from`, 1 at `to`; the middle of a range that has no width.
    double share(double value) const { return to > from ? (value - from) / (to - from) : 0.5; }
};

/// The range that a curve's sheet shows: all values and the whole band with a tenth of it for air; a curve that wanders
/// far off shows at most three outer half widths to either side.
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

/// A rectangle with axes, y growing downwards, in whichever unit.
struct CurveSheet {
    double left = 0, top = 0, right = 0, bottom = 0;
    CurveRange places; ///< mm along the seam
    CurveRange values; ///< in the curve's unit

    double x(double place) const { return left + places.share(place) * (right - left); }
    /// A value beyond the shown ones lies on the edge.
    double y(double value) const;
};

} // namespace meltpool
