// The suite `card`: the cost of a graphics card's work in about two minutes, from the driver's price of a pass to both
// eyes of a headset over a fine weld.
#pragma once

#include "app/bench/bench.hpp"
#include "core/training/lesson/lesson.hpp"

namespace meltpool {

/// Limits of a measurement, so that a slow machine finishes too.
struct CardLimits {
    double seconds = 20;       ///< s of wall time for each row at most; a begun repeat is completed
    int repeats = 400;         ///< timed repeats at most
    double longestPool = 2;    ///< s: no larger pool is measured after one that takes longer
    int largestPool = 1 << 20; ///< moving particles
    int eyeWidth = 2064;       ///< pixels of an eye: size that a headset of 2023 asks for
    int eyeHeight = 2208;      ///< pixels
    double weldSeconds = 1;    ///< simulated s of a fine weld before its steps are measured
};

/// Measures eight substeps of the flow, about as many as a weld's step has, with free liquid of some 256 particles,
/// then four times as many each, in a row each.
void measurePools(Bench& bench, const CardLimits& limits);
/// Measures a step of the lesson's weld, and both eyes' picture of it in one submission with 4 samples.
void measureWeldAndEyes(Bench& bench, const Lesson& lesson, const CardLimits& limits);

} // namespace meltpool
