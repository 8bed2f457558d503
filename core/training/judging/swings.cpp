#include "core/training/judging/swings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

constexpr size_t kLeastSwings = 3;
constexpr double kNear = 0.1;     ///< share of the way that still counts as at the toe
constexpr double kRaise = 1.3;    // factor of the least swing, while tremor is as large
constexpr double kMostTremor = 5; // tremor in least swings above which no swing is found
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A way from one toe to the next.
struct HalfSwing {
    double from = 0, to = 0;
    double seconds = 0;                         ///< time from toe to toe
    double leaves = 0, middle = 0, arrives = 0; ///< s, at a tenth, half and nine tenths of the way

    double width() const { return std::abs(to - from); }
    double tenths() const { return (arrives - leaves) * kNear / (1 - 2 * kNear); }
};

/// Indices at which the values turn back by `least` or more. The first is the start of the values, not a toe.
std::vector<size_t> turningPoints(std::span<const double> values, double least) {
    std::vector<size_t> points;
    size_t low = 0, high = 0;
    int way = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        if (values[i] > values[high]) high = i;
        if (values[i] < values[low]) low = i;
        if (way <= 0 && values[i] - values[low] >= least) {
            points.push_back(low);
            way = 1;
            high = i;
        } else if (way >= 0 && values[high] - values[i] >= least) {
            points.push_back(high);
            way = -1;
            low = i;
        }
    }
    return points;
}

/// The turning points of the smallest swings that are not tremor: `least` is raised until none is faster than
/// `shortest`.
std::vector<size_t> toesOf(std::span<const double> times, std::span<const double> values, const SwingLimits& limits) {
    std::vector<size_t> toes;
    for (double least = limits.least; least < kMostTremor * limits.least; least *= kRaise) {
        toes = turningPoints(values, least);
        const auto tooFast = [&](size_t from, size_t to) { return times[to] - times[from] < limits.shortest; };
        if (toes.size() < 3 || std::adjacent_find(toes.begin() + 1, toes.end(), tooFast) == toes.end()) return toes;
    }
    return {};
}

HalfSwing halfSwing(std::span<const double> times, std::span<const double> values, size_t begin, size_t end) {
    HalfSwing half{values[begin], values[end], times[end] - times[begin], times[begin], kUnknown, times[end]};
    const auto share = [&](size_t i) { return (values[i] - half.from) / (half.to - half.from); };
    for (size_t i = begin + 1; i <= end; ++i) {
        const double before = share(i - 1), now = share(i);
        const auto crossing = [&](double level) {
            return times[i - 1] + (times[i] - times[i - 1]) * (level - before) / (now - before);
        };
        const bool halfWay = !std::isnan(half.middle);
        if (!halfWay && before < kNear && now >= kNear) half.leaves = crossing(kNear);
        if (!halfWay && before < 0.5 && now >= 0.5) half.middle = crossing(0.5);
        if (before < 1 - kNear && now >= 1 - kNear) {
            half.arrives = crossing(1 - kNear);
            break;
        }
    }
    return half;
}

/// Dwell at the toe between two ways, s.
double dwellBetween(const HalfSwing& before, const HalfSwing& after) {
    return std::max(after.leaves - before.arrives - before.tenths() - after.tenths(), 0.0);
}

/// A swing from way `k` and the toes at its ends.
Swing swingOf(std::span<const HalfSwing> halves, size_t k) {
    const HalfSwing& half = halves[k];
    // The first and the last way take period and rate of their neighbours.
    const size_t inner = std::clamp(k, size_t(1), halves.size() - 2);
    const HalfSwing &before = halves[inner - 1], &after = halves[inner + 1];
    const auto centre = [](const HalfSwing& each) { return (each.from + each.to) / 2; };
    Swing swing;
    swing.time = half.middle;
    swing.centre = centre(half);
    swing.width = (before.width() + 2 * halves[inner].width() + after.width()) / 4;
    swing.period = after.middle - before.middle;
    swing.rate = (centre(after) - centre(before)) / swing.period;
    const double first = dwellBetween(before, halves[inner]), second = dwellBetween(halves[inner], after);
    const bool up = halves[inner].to > halves[inner].from;
    swing.dwellLow = up ? first : second;
    swing.dwellHigh = up ? second : first;
    return swing;
}

SwingRun runOf(std::span<const HalfSwing> halves) {
    SwingRun run;
    for (size_t k = 0; k < halves.size(); ++k)
        run.swings.push_back(swingOf(halves, k));
    run.begin = run.swings.front().time - run.swings.front().period;
    run.end = run.swings.back().time + run.swings.back().period;
    return run;
}

} // namespace

std::vector<SwingRun> findSwings(std::span<const double> times, std::span<const double> values,
                                 const SwingLimits& limits) {
    const std::vector<size_t> toes = toesOf(times, values, limits);
    std::vector<SwingRun> runs;
    std::vector<HalfSwing> halves;
    const auto finishRun = [&] {
        if (halves.size() >= kLeastSwings) runs.push_back(runOf(halves));
        halves.clear();
    };
    for (size_t i = 2; i < toes.size(); ++i) {
        if (times[toes[i]] - times[toes[i - 1]] > limits.longest) {
            finishRun();
            continue;
        }
        halves.push_back(halfSwing(times, values, toes[i - 1], toes[i]));
    }
    finishRun();
    return runs;
}

const Swing* SwingRun::at(double time) const {
    if (time < begin || time > end) return nullptr;
    const auto after = std::lower_bound(swings.begin(), swings.end(), time,
                                        [](const Swing& swing, double wanted) { return swing.time < wanted; });
    if (after == swings.begin()) return &*after;
    const auto before = std::prev(after);
    if (after == swings.end()) return &*before;
    return time - before->time < after->time - time ? &*before : &*after;
}

double SwingRun::centreAt(double time) const {
    const auto after = std::lower_bound(swings.begin(), swings.end(), time,
                                        [](const Swing& swing, double wanted) { return swing.time < wanted; });
    if (after == swings.begin()) return after->centre + (time - after->time) * after->rate;
    const auto before = std::prev(after);
    if (after == swings.end()) return before->centre + (time - before->time) * before->rate;
    return before->centre + (after->centre - before->centre) * (time - before->time) / (after->time - before->time);
}

} // namespace meltpool
