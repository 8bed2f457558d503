// The suite `looks`: the cost of each measure of the picture's detail.
#pragma once

#include "app/bench/bench.hpp"
#include "core/training/lesson/lesson.hpp"

namespace meltpool {

/// Settings of the measurement.
struct LooksMeasurement {
    double moment = 1.5;            ///< simulated s of the demonstration before the picture
    int width = 1280, height = 720; ///< pixels of an eye
    int rounds = 5;                 ///< turns of all rows, so that other load on the machine falls on all
    double seconds = 0.3;           ///< s of a row in a round
};

/// Draws one moment of the lesson for one eye and for two: at each level of detail, and at the highest without each
/// measure in turn (see core/render/look/measures.hpp). Each row's GPU times are under `passes`. Further numbers, each
/// per eye: `cpu_ms` of all the program's threads, `gpu_ms`; of a row without a measure also the measure's cost,
/// `measure_cpu_ms` and `measure_gpu_ms`; of a level `cpu_over_high`.
void measureLooks(Bench& bench, const Lesson& lesson, const LooksMeasurement& measurement);

} // namespace meltpool
