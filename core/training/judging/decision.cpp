#include "core/training/judging/decision.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kCoverage = 2;    ///< standard errors in an uncertainty: nineteen of twenty means are nearer
constexpr double kRounding = 1e-6; ///< mm or degrees: spacings in single precision, sums

} // namespace

VerdictState decide(double excess, double uncertainty) {
    if (excess > uncertainty + kRounding) return VerdictState::fail;
    return excess <= -uncertainty + kRounding ? VerdictState::pass : VerdictState::notResolved;
}

double ReadingUncertainty::independent(size_t count) const {
    const double stations = static_cast<double>(count);
    return cut > pitch ? 1 + (stations - 1) * pitch / cut : stations;
}

double ReadingUncertainty::ofMean(size_t count) const {
    return std::max(single / std::sqrt(independent(count)), std::min(least, single));
}

double ReadingUncertainty::ofWhole(std::span<const double> values) const {
    const double particles = ofMean(values.size()), readings = independent(values.size());
    if (readings < kLeastForScatter) return particles;
    double mean = 0, squares = 0;
    for (const double value : values)
        mean += value / static_cast<double>(values.size());
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    const double scatter = std::sqrt(squares / static_cast<double>(values.size() - 1));
    return std::min(particles, std::max(kCoverage * scatter / std::sqrt(readings), std::min(least, single)));
}

ReadingRun meanOf(std::span<const Reading> readings, size_t first, size_t count, double allowed,
                  const ReadingUncertainty& uncertainty) {
    const std::span<const Reading> run = readings.subspan(first, count);
    const double stations = static_cast<double>(count);
    const double share = std::clamp(allowed / (stations * uncertainty.pitch), 0.0, 1.0);
    ReadingRun mean{first, count, 0, 0, 0, 0, 0};
    for (const Reading& each : run) {
        mean.value += each.value / stations;
        mean.limit += std::lerp(each.limit, each.shortLimit, share) / stations;
        mean.excess += std::lerp(each.excess, each.shortExcess, share) / stations;
    }
    mean.uncertainty = uncertainty.ofMean(count);
    mean.place = 0.5 * (run.front().place + run.back().place);
    return mean;
}

} // namespace meltpool
