// Figures of the running lesson's metal for menus and telemetry.
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
    std::string_view slow = {};    ///< message that the metal is slow; empty: it keeps up
    std::string_view picture = {}; ///< message that the picture has fewer pixels than the window; empty: it has all
    std::string_view detail = {};  ///< message that the detail is reduced; empty: it is the highest
    std::string_view caption = {}; ///< caption of the sound; empty: silence, or captions are off
    double framesPerSecond = 0;
    size_t particles = 0;
    size_t molten = 0;
    double hottest = 0;   ///< 0..1, or K
    bool kelvin = false;  ///< true: hottest is in K
    size_t lost = 0;      ///< particles that left the box or whose state became non-finite
    size_t refused = 0;   ///< non-finite new particle states that were rejected since the reset
    bool stopped = false; ///< true: a fault stopped the simulation
    /// Pose of the desk's torch, if it leads, with the distance that is judged, and the kind of that distance.
    std::optional<DeskPose> torch;
    DistanceKind distance = DistanceKind::ctwd;
};

/// Sets the lesson's figures. Those of the picture, and all of them without a running lesson, do not change.
void fillFigures(LessonFigures& figures, LessonSession& session);

} // namespace meltpool
