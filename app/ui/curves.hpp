// Draws a chart of one or two curves with axes and the wanted band: the result along the seam, a replay over time, two
// attempts over each other. It allocates nothing.
#pragma once

#include "app/report/curve_scale.hpp"
#include "app/ui/widgets.hpp"
#include "core/base/function_ref.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace meltpool::ui {

constexpr ImU32 kCurveTint = IM_COL32(108, 178, 255, 255);
/// Tint of the first of two curves; the second has kCurveTint.
constexpr ImU32 kFirstTint = IM_COL32(255, 178, 122, 255);

/// One curve; borrowed for the call.
struct CurveSeries {
    size_t count = 0;                  ///< number of points
    FunctionRef<double(size_t)> place; ///< ascending
    FunctionRef<double(size_t)> value; ///< NaN if unknown
    double gap = 0;                    ///< longest distance between two joined points with a value
    ImU32 tint = kCurveTint;
};

struct CurveChart {
    std::string_view name; ///< name of the control
    std::string_view title, unit;
    std::string_view placeUnit = "mm";
    std::optional<CurveBand> band;
    CurveRange places =
        {};            ///< shown places in addition to the points' own; with them the chart appears before any value
    float height = 84; ///< points
    std::optional<double> cursor = {}; ///< place whose value is shown while the pointer is elsewhere
};

/// Outcome of a drawn chart.
struct CurveAnswer {
    bool drawn = false; ///< false if no value is known
    bool clicked = false;
    bool hovered = false;
    double under = 0; ///< the place under the pointer
    CurveSheet sheet; ///< places in pixels of the screen, for marks
};

/// Draws the chart over the whole remaining width. The value under the pointer is at the right of the title.
CurveAnswer curveChart(Context& context, const CurveChart& chart, std::span<const CurveSeries> series);

/// Draws a line from top to bottom of a chart.
void curveMark(Context& context, const CurveSheet& sheet, double place, ImU32 tint, float thickness = 1);

} // namespace meltpool::ui
