// The suite `lesson`: a whole lesson as for a trainee, with metal, surface and pictures.
#pragma once

#include "app/bench/bench.hpp"
#include "core/training/lesson/lesson.hpp"

namespace meltpool {

/// Settings of the measurement.
struct LessonMeasurement {
    double warmUp = 3;              ///< simulated s before measuring: by then a bead's pool is about as long as it gets
    int seconds = 3;                ///< simulated s to measure, each of them a repeat
    int picturesPerSecond = 30;     ///< per simulated second
    int width = 1280, height = 720; ///< pixels
};

/// Runs the lesson's demonstration. The row's time is the least wall time of a simulated second, ms. Further numbers:
/// `simulated_over_wall` over the whole measurement, `simulated_over_wall_best` of the quickest second, the share of
/// the wall time that physics, surface, pictures and the rest have (`physics_share`, ..; the GPU is waited for between
/// them), and steps, pictures and dispatches in a simulated second.
BenchRow measureLesson(Bench& bench, const Lesson& lesson, const LessonMeasurement& measurement);

} // namespace meltpool
