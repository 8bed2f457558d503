// The suite `looks`: what each measure of the picture's detail costs.
#pragma once

#include "app/bench/bench.hpp"
#include "core/training/lesson/lesson.hpp"

namespace meltpool {

/// How looks are measured.
struct LooksMeasurement {
    double moment = 1.5;            ///< simulated s of the demonstration before the picture
    int width = 1280, height = 720; ///< pixels of an eye
    int rounds = 5;                 ///< all rows take turns so often, so that what else the machine does falls on all
    double seconds = 0.3;           ///< of a row in a round
};

/// Draws one moment of the lesson for one eye and for two: at each level of detail, and at the highest without each
/// measure in turn (see core/render/look/measures.hpp). Each row's GPU times stand under `passes`. Further numbers,
/// each of an eye: `cpu_ms` of all the program's threads, `gpu_ms`; of a row without a measure also what the measure
/// costs, `measure_cpu_ms` and `measure_gpu_ms`; of a level `cpu_over_high`.
void measureLooks(Bench& bench, const Lesson& lesson, const LooksMeasurement& measurement);

} // namespace meltpool
