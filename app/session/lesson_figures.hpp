// What menus and telemetry show of the metal in a running lesson.
#pragma once

#include <cstddef>

namespace meltpool {

struct LessonFigures {
    double time = 0;  ///< simulated seconds
    double speed = 1; ///< simulated over real time
    double framesPerSecond = 0;
    size_t particles = 0;
    size_t molten = 0;
    double hottest = 0;   ///< 0..1, or K
    bool kelvin = false;  ///< which of the two
    size_t lost = 0;      ///< particles that left the box or became no number
    size_t refused = 0;   ///< new particle states that were no number and were refused, since the reset
    bool stopped = false; ///< the state is no longer finite and the simulation stands still
};

} // namespace meltpool
