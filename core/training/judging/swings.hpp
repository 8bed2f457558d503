// Movements to and fro in a series of values: weave, whip, and dips of the rod.
#pragma once

#include <span>
#include <vector>

namespace meltpool {

/// What counts as a swing.
struct SwingLimits {
    double least = 1e-3;    ///< from toe to toe, in the values' unit; what turns back earlier is tremor
    double shortest = 0.15; ///< s from toe to toe; what is faster is tremor too, and only larger swings are looked for
    double longest = 2.5;   ///< s from toe to toe; what is slower is drift
};

/// One way from toe to toe; times in s, values in their own unit.
struct Swing {
    double time = 0;      ///< of the middle between the toes
    double centre = 0;    ///< the value there
    double width = 0;     ///< from toe to toe, without the drift: the mean of the ways to and fro
    double period = 0;    ///< of to and fro
    double rate = 0;      ///< drift, a second: of the centre over one period
    double dwellLow = 0;  ///< s at the lower toe, see findSwings()
    double dwellHigh = 0; ///< s at the upper toe
};

/// Swings that follow one another.
struct SwingRun {
    std::vector<Swing> swings; ///< at least three
    double begin = 0;          ///< s, a period before the first
    double end = 0;            ///< s, a period after the last

    /// The swing nearest to `time`; null outside of the run.
    const Swing* at(double time) const;
    /// The centre line at `time`, straight between swings.
    double centreAt(double time) const;
};

/// The runs of swings in `values` at ascending `times`. The way before the first toe and that after the last are none:
/// nobody knows where they began or will end. Dwell at a toe is the time within a tenth of the way from it, less what
/// the next tenths at the mean speed of the ways before and after would take: that of a zigzag with pauses is the
/// pause, that of a sine is 0.131 of its period.
std::vector<SwingRun> findSwings(std::span<const double> times, std::span<const double> values,
                                 const SwingLimits& limits);

} // namespace meltpool
