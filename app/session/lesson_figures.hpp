// What menus and telemetry show of the metal in a running lesson.
#pragma once

#include "app/session/desk_torch.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace meltpool {

class LessonSession;

struct LessonFigures {
    double time = 0;               ///< simulated seconds
    double speed = 1;              ///< simulated over real time
    std::string_view slow = {};    ///< that the metal runs slowly, for the person; empty: it keeps up
    std::string_view picture = {}; ///< that it is drawn with fewer pixels than the window has; empty: with all
    std::string_view detail = {};  ///< that its detail is not the highest; empty: it is
    std::string_view caption = {}; ///< what is heard; empty: nothing, or captions are off
    double framesPerSecond = 0;
    size_t particles = 0;
    size_t molten = 0;
    double hottest = 0;   ///< 0..1, or K
    bool kelvin = false;  ///< which of the two
    size_t lost = 0;      ///< particles that left the box or whose state became non-finite
    size_t refused = 0;   ///< non-finite new particle states that were not taken over, since the reset
    bool stopped = false; ///< a fault has stopped the simulation
    /// How the torch of the desk is held, where it leads, and what its distance is.
    std::optional<DeskPose> torch;
    DistanceKind distance = DistanceKind::ctwd;
};

/// The figures of the lesson as it is now; those of the picture, and all of them without a running lesson, stay.
void fillFigures(LessonFigures& figures, LessonSession& session);

} // namespace meltpool
