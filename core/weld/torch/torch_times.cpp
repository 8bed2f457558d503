#include "core/weld/torch/torch_times.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr std::array<const char*, 4> kUnits{"s", "ms", "us", "ns"}; ///< units, each a thousandth of the one before
constexpr double kLatestDate = 1e11;                                ///< s after 1970: the year 5138
constexpr double kFarApart = 1;                                     ///< s between rows, which no recorder leaves
constexpr double kHour = 3600;                                      ///< s
constexpr double kCrawl = 5e-5;                                     ///< m/s, slower than any torch travels
constexpr size_t kManyRows = 10;                                    ///< number of rows for which a speed is reliable

double medianStep(const std::vector<TorchSample>& samples) {
    std::vector<double> steps;
    for (size_t i = 1; i < samples.size(); ++i)
        steps.push_back(samples[i].time - samples[i - 1].time);
    if (steps.empty()) return 0;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

double wayOf(const std::vector<TorchSample>& samples) {
    double way = 0;
    for (size_t i = 1; i < samples.size(); ++i)
        way += static_cast<double>(glm::distance(samples[i - 1].tip, samples[i].tip));
    return way;
}

/// Returns the number of times that the unit must be divided by a thousand to make the times plausible.
size_t thousandths(const std::vector<TorchSample>& samples) {
    const double duration = samples.back().time - samples.front().time, step = medianStep(samples);
    const double way = wayOf(samples), first = std::abs(samples.front().time);
    size_t times = 0;
    for (double factor = 1; times + 1 < kUnits.size(); factor *= 1e-3, ++times) {
        const double seconds = duration * factor;
        const bool crawls = samples.size() >= kManyRows && way > 0 && way < kCrawl * seconds;
        const bool apart = samples.size() > 2 && step * factor >= kFarApart && (seconds > kHour || crawls);
        if (first * factor < kLatestDate && !apart) break;
    }
    return times;
}

} // namespace

TorchClock settleTimes(std::vector<TorchSample>& samples, double factor, bool judge) {
    TorchClock clock;
    if (samples.empty()) return clock;
    size_t unit = judge ? thousandths(samples) : 0;
    clock.judged = unit > 0;
    for (size_t i = 0; i < unit; ++i)
        factor *= 1e-3;
    for (double told = factor; !clock.judged && told < 0.5 && unit + 1 < kUnits.size(); told *= 1e3)
        ++unit;
    clock.unit = kUnits[unit];
    const double first = samples.front().time;
    clock.shifted = first < 0 || first * factor >= kLongestPause;
    if (clock.shifted) clock.begin = first * factor;
    if (factor == 1 && !clock.shifted) return clock;
    for (TorchSample& sample : samples)
        sample.time = (sample.time - (clock.shifted ? first : 0)) * factor;
    return clock;
}

} // namespace meltpool
