#include "core/metal/material/materials.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

Property Property::constant(double value, std::string source) {
    return {{{0.0, value}}, std::move(source)};
}

double Property::at(double temperature) const {
    if (temperature <= points.front().temperature) return points.front().value;
    if (temperature >= points.back().temperature) return points.back().value;
    const auto after = std::upper_bound(points.begin(), points.end(), temperature,
                                        [](double t, const Point& point) { return t < point.temperature; });
    const auto before = after - 1;
    const double share = (temperature - before->temperature) / (after->temperature - before->temperature);
    return before->value + share * (after->value - before->value);
}

double Property::integral(double from, double to) const {
    if (to < from) return -integral(to, from);
    double sum = 0;
    double left = from;
    // The trapezium is exact: between two neighbouring points the value is linear.
    const auto add = [&](double right) {
        sum += 0.5 * (at(left) + at(right)) * (right - left);
        left = right;
    };
    for (const Point& point : points)
        if (point.temperature > left && point.temperature < to) add(point.temperature);
    add(to);
    return sum;
}

double Material::tensionAt(double temperature) const {
    constexpr double kGas = 8.314462;      // J/(mol K)
    constexpr double kSaturation = 1.3e-5; // mol/m² of a surface saturated with sulphur
    constexpr double kOrder = 3.18e-3;
    constexpr double kAdsorption = 1.66e5; // J/mol
    if (sulphur <= 0) return surfaceTension.at(temperature);
    const double taken = kOrder * std::exp(kAdsorption / (kGas * temperature)) * sulphur;
    return surfaceTension.at(temperature) - kGas * temperature * kSaturation * std::log1p(taken);
}

double Material::tensionSlopeAt(double temperature) const {
    const double step = 10;
    return (tensionAt(temperature + step) - tensionAt(temperature)) / step;
}

} // namespace meltpool
