// A chart of one or two curves with axes and the band that is asked for: of the result along the seam, of a replay over
// time, of two attempts over each other. It allocates nothing.
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
constexpr ImU32 kFirstTint = IM_COL32(255, 178, 122, 255); ///< of two, the second has kCurveTint

/// One curve; borrowed for the call.
struct CurveSeries {
    size_t count = 0;                  ///< of its points
    FunctionRef<double(size_t)> place; ///< ascending
    FunctionRef<double(size_t)> value; ///< NaN where nothing is known
    double gap = 0;                    ///< points with a value that are farther apart are not joined
    ImU32 tint = kCurveTint;
};

struct CurveChart {
    std::string_view name; ///< of the control
    std::string_view title, unit;
    std::string_view placeUnit = "mm";
    std::optional<CurveBand> band;
    CurveRange places =
        {};            ///< that are shown beside those of the points; with them the chart is there before any value
    float height = 84; ///< points
};

/// What became of a chart.
struct CurveAnswer {
    bool drawn = false; ///< nothing is where no value is known
    bool clicked = false;
    bool hovered = false;
    double under = 0; ///< the place under the pointer
    CurveSheet sheet; ///< in pixels of the screen, for marks on it
};

/// Draws the chart over the whole width that is left. The value under the pointer stands at the right of the title.
CurveAnswer curveChart(Context& context, const CurveChart& chart, std::span<const CurveSeries> series);

/// A line from top to bottom of a chart.
void curveMark(Context& context, const CurveSheet& sheet, double place, ImU32 tint, float thickness = 1);

} // namespace meltpool::ui
