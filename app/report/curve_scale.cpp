#include "app/report/curve_scale.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kAir = 1.1;         ///< factor on the band, for air around it
constexpr double kFarthest = 3;      ///< outer half widths that are shown
constexpr double kFlat = 1e-3;       ///< share of its size within which a curve counts as flat
constexpr double kAround = 0.05;     ///< share of its size shown above and below a flat one
constexpr double kLeastWidth = 1e-6; ///< least band, in its unit

} // namespace

void CurveRange::take(double value) {
    if (!std::isfinite(value)) return;
    from = std::min(from, value);
    to = std::max(to, value);
}

CurveRange shownRange(const CurveRange& values, const std::optional<CurveBand>& band) {
    if (values.empty()) return values;
    if (!band) {
        // A constant value gets a readable axis, not its last digits as mountains.
        const double middle = 0.5 * (values.from + values.to), size = std::max(std::abs(middle), 1.0);
        if (values.to - values.from > kFlat * size) return values;
        return {middle - kAround * size, middle + kAround * size};
    }
    const double outer = std::max(band->outer, kLeastWidth);
    return {std::clamp(values.from, band->ideal - kFarthest * outer, band->ideal - kAir * outer),
            std::clamp(values.to, band->ideal + kAir * outer, band->ideal + kFarthest * outer)};
}

CurveTicks curveTicks(const CurveRange& range, int about) {
    if (!(range.to > range.from) || about < 1) return {};
    const double rough = (range.to - range.from) / about, power = std::pow(10, std::floor(std::log10(rough)));
    CurveTicks ticks;
    ticks.step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= rough) ticks.step = factor * power;
    constexpr double kRounding = 1e-9; // steps
    const double first = std::ceil(range.from / ticks.step - kRounding);
    const double last = std::floor(range.to / ticks.step + kRounding);
    ticks.first = first * ticks.step;
    ticks.count = static_cast<int>(std::max(0.0, last - first + 1));
    return ticks;
}

double CurveSheet::y(double value) const {
    return bottom - values.share(std::clamp(value, values.from, values.to)) * (bottom - top);
}

} // namespace meltpool
