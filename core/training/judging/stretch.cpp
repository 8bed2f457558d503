#include "core/training/judging/stretch.hpp"

#include "core/training/judging/swings.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

using enum TechniqueQuantity;
using Steps = std::span<const TechniqueStep>;

/// s from toe to toe; slower swings of the torch are drift, slower dips of the rod are pauses.
constexpr double kLongestSwing = 2.5;
constexpr double kLongestDip = 4;
/// s; faster ones are tremor. A dip is a jab.
constexpr double kShortestSwing = 0.15;
constexpr double kShortestDip = 0.08;

/// Swings of one value of the steps, without the steps where it is unknown.
std::vector<SwingRun> swingsOf(Steps steps, double TechniqueStep::*value, const SwingLimits& limits) {
    std::vector<double> times, values;
    times.reserve(steps.size());
    values.reserve(steps.size());
    for (const TechniqueStep& step : steps) {
        if (std::isnan(step.*value)) continue;
        times.push_back(step.time);
        values.push_back(step.*value);
    }
    return findSwings(times, values, limits);
}

/// Walks through runs in the order of time.
class RunCursor {
  public:
    explicit RunCursor(const std::vector<SwingRun>& runs) : runs_(runs) {}

    /// The run at `time`, which must not decrease; null between runs.
    const SwingRun* at(double time) {
        while (next_ < runs_.size() && runs_[next_].end < time)
            ++next_;
        return next_ < runs_.size() && runs_[next_].begin <= time ? &runs_[next_] : nullptr;
    }

  private:
    const std::vector<SwingRun>& runs_;
    size_t next_ = 0;
};

/// Sets the direction of travel in every step; a direction sensed late holds from the torch's turn on.
void setDirections(Steps steps, int before, std::vector<StretchValues>& result) {
    DirectionSense sense;
    size_t known = 0;    // steps before it have their direction
    size_t farthest = 0; // farthest step, in the direction of travel
    for (size_t i = 0; i < steps.size(); ++i) {
        const int last = sense.direction();
        const int now = sense.add(steps[i].place);
        if (now != last) {
            const size_t turn = last == 0 ? 0 : farthest;
            for (size_t k = known; k < turn; ++k)
                result[k].direction = last;
            known = turn;
            farthest = i;
        }
        if (now * (steps[i].place - steps[farthest].place) > 0) farthest = i;
    }
    const int found = sense.direction();
    for (size_t k = known; k < steps.size(); ++k)
        result[k].direction = found == 0 ? before : found;
}

/// Sets the slope of place against time in every step, over a window that is centred on it as far as the stretch
/// reaches.
void setSpeeds(Steps steps, double window, std::vector<StretchValues>& result) {
    const double begin = steps.front().time, end = steps.back().time;
    if (end - begin < kLeastSpeedSpan) return;
    SlidingSlope slope;
    size_t first = 0, next = 0;
    for (size_t i = 0; i < steps.size(); ++i) {
        const double from = std::clamp(steps[i].time - window / 2, begin, std::max(begin, end - window));
        for (; next < steps.size() && steps[next].time <= from + window; ++next)
            slope.add(steps[next].time - begin, steps[next].place);
        for (; first < next && steps[first].time < from; ++first)
            slope.remove(steps[first].time - begin, steps[first].place);
        const double speed = slope.slope();
        const int direction = result[i].direction;
        result[i].values[travelSpeed] = direction == 0 ? std::abs(speed) : direction * speed;
    }
}

void setWeave(Steps steps, std::vector<StretchValues>& result) {
    const std::vector<SwingRun> runs =
        swingsOf(steps, &TechniqueStep::aim, {kLeastWeave, kShortestSwing, kLongestSwing});
    RunCursor cursor(runs);
    for (size_t i = 0; i < steps.size(); ++i) {
        TechniqueValues& values = result[i].values;
        const SwingRun* run = cursor.at(steps[i].time);
        const Swing* swing = run ? run->at(steps[i].time) : nullptr;
        values[aim] = swing ? run->centreAt(steps[i].time) : steps[i].aim;
        values[weaveWidth] = swing ? swing->width : 0;
        values[weaveFrequency] = swing ? 1 / swing->period : 0;
        values[weaveDwell] = swing ? (swing->dwellLow + swing->dwellHigh) / 2 : 0;
    }
}

void setWhip(Steps steps, std::vector<StretchValues>& result) {
    const std::vector<SwingRun> runs =
        swingsOf(steps, &TechniqueStep::place, {kLeastWhip, kShortestSwing, kLongestSwing});
    RunCursor cursor(runs);
    for (size_t i = 0; i < steps.size(); ++i) {
        TechniqueValues& values = result[i].values;
        const SwingRun* run = cursor.at(steps[i].time);
        const Swing* swing = run ? run->at(steps[i].time) : nullptr;
        values[whipLength] = swing ? swing->width : 0;
        values[whipPeriod] = swing ? swing->period : 0;
        values[whipDwell] = !swing ? 0 : result[i].direction < 0 ? swing->dwellHigh : swing->dwellLow;
        if (!swing) continue;
        const int direction = result[i].direction;
        values[travelSpeed] = direction == 0 ? std::abs(swing->rate) : direction * swing->rate;
    }
}

void setRod(Steps steps, std::vector<StretchValues>& result) {
    const std::vector<SwingRun> runs = swingsOf(steps, &TechniqueStep::rodGap, {kLeastDip, kShortestDip, kLongestDip});
    RunCursor cursor(runs);
    for (size_t i = 0; i < steps.size(); ++i) {
        if (std::isnan(steps[i].rodGap)) continue;
        const SwingRun* run = cursor.at(steps[i].time);
        const Swing* swing = run ? run->at(steps[i].time) : nullptr;
        result[i].values[rodAngle] = steps[i].rodAngle;
        result[i].values[rodFrequency] = swing ? 1 / swing->period : 0;
    }
}

} // namespace

std::vector<StepRange> weldedStretches(Steps steps) {
    std::vector<StepRange> stretches;
    for (size_t i = 0; i < steps.size(); ++i) {
        if (!steps[i].welds) continue;
        if (stretches.empty() || !steps[i].joined) stretches.push_back({i, i});
        stretches.back().end = i + 1;
    }
    return stretches;
}

std::vector<StretchValues> analyseStretch(Steps stretch, const TechniqueSettings& settings, int direction) {
    std::vector<StretchValues> result(stretch.size());
    setDirections(stretch, direction, result);
    setSpeeds(stretch, settings.speedWindow, result);
    setWeave(stretch, result);
    setWhip(stretch, result);
    setRod(stretch, result);
    for (size_t i = 0; i < stretch.size(); ++i) {
        TechniqueValues& values = result[i].values;
        values[height] = stretch[i].height;
        values[distance] = stretch[i].distance;
        values[workAngle] = stretch[i].workAngle;
        if (result[i].direction != 0) values[travelAngle] = result[i].direction * stretch[i].lean;
    }
    return result;
}

} // namespace meltpool
