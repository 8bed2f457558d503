// Finds movements to and fro in a series of values: weave, whip, and dips of the rod.
#pragma once

#include <span>
#include <vector>

namespace meltpool {

/// Limits of a swing.
struct SwingLimits {
    double least = 1e-3;    ///< width from toe to toe, in the values' unit; smaller movements are tremor
    double shortest = 0.15; ///< s from toe to toe; faster movements are tremor too, and only larger swings are searched
    double longest = 2.5;   ///< s from toe to toe; slower movements are drift
};

/// One way from toe to toe; times in s, values in their own unit.
struct Swing {
    double time = 0;      ///< at the middle between the toes
    double centre = 0;    ///< value at the middle
    double width = 0;     ///< width from toe to toe, without the drift: the mean of the ways to and fro
    double period = 0;    ///< period of a swing to and fro
    double rate = 0;      ///< drift of the centre per second, over one period
    double dwellLow = 0;  ///< s at the lower toe, see findSwings()
    double dwellHigh = 0; ///< s at the upper toe
};

/// Consecutive swings.
struct SwingRun {
    std::vector<Swing> swings; ///< at least three
    double begin = 0;          ///< s, a period before the first
    double end = 0;            ///< s, a period after the last

    /// The swing nearest to `time`; null outside of the run.
    const Swing* at(double time) const;
    /// The centre line at `time`, straight between swings.
    double centreAt(double time) const;
};

/// The runs of swings in `values` at ascending `times`. The way before the first toe and the way after the last do not
/// count: their other ends are unknown. Dwell at a toe is the time within a tenth of the way from it, minus the time of
/// the next tenths at the mean speed of the ways before and after: for a zigzag with pauses that is the pause, for a
/// sine 0.131 of its period.
std::vector<SwingRun> findSwings(std::span<const double> times, std::span<const double> values,
                                 const SwingLimits& limits);

} // namespace meltpool
