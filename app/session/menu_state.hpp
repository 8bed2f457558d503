// Which menus are open, and what a person asks for in them.
#pragma once

#include "core/base/parameter.hpp"

namespace meltpool {

/// Which panels of the window are open.
struct PanelState {
    bool view = false;
    bool simulation = true;
    bool timings = false;
    bool result = false; ///< the attempt judged
    bool help = false;
    bool hidden = false; ///< no panel is shown
};
ParameterList describe(PanelState& panels);

namespace ui {

/// A control's place on the screen in points, for tests.
struct Place {
    float x = 0;
    float y = 0;
    float width = 0;
    float height = 0;
    unsigned frame = 0; ///< in which it was last drawn there
};

} // namespace ui

/// What a person asked for with a button.
enum class MenuRequest {
    none,
    home,              ///< the list of lessons
    openLesson,        ///< the one that is chosen in it
    next,              ///< the lesson that follows this one
    start,             ///< the lesson, with the values as they stand
    demonstrate,       ///< the lesson's demonstration
    replay,            ///< the kept attempt that is chosen in their list
    ghost,             ///< an attempt of one's own, with the chosen one's torch beside
    compare,           ///< the two kept attempts that were marked
    startWithDefaults, ///< the lesson, with its own values
    reset,             ///< another attempt
    restart,           ///< back to the lesson's first page
    judge,
    page, ///< of the judged attempt, written as a file
    redo, ///< back to before the chosen fault, or some seconds
    cut   ///< the weld open, or closed again
};

} // namespace meltpool
