// Open menus, and a person's requests in them.
#pragma once

#include "core/base/parameter.hpp"

namespace meltpool {

/// Open panels of the window.
struct PanelState {
    bool view = false;
    bool simulation = true;
    bool timings = false;
    bool result = false; ///< result of the judged attempt
    bool help = false;
    bool settings = false; ///< settings of the program, over the list of lessons
    bool hidden = false; ///< true: no panel is shown

    /// True while a page lies over everything: keys belong to it.
    bool overlaid() const { return help || settings; }
};
ParameterList describe(PanelState& panels);

namespace ui {

/// A control's place on the screen in points, for tests.
struct Place {
    float x = 0;
    float y = 0;
    float width = 0;
    float height = 0;
    unsigned frame = 0; ///< frame in which it was last drawn there
};

} // namespace ui

/// Requests of a person by button.
enum class MenuRequest {
    none,
    home,              ///< the list of lessons
    openLesson,        ///< the lesson chosen in the list
    next,              ///< the lesson that follows this one
    start,             ///< the lesson, with the current values
    demonstrate,       ///< the lesson's demonstration
    replay,            ///< the stored attempt chosen in the list
    ghost,             ///< an attempt of one's own, with the chosen one's torch as a ghost
    compare,           ///< the two marked stored attempts
    keptPage,          ///< the page of the stored attempt chosen in the list
    exportAttempts,    ///< the list's shown rows, written as a table
    startWithDefaults, ///< the lesson, with its own values
    reset,             ///< another attempt
    restart,           ///< back to the lesson's first page
    judge,
    pause,   ///< the lesson, or go on with it
    page,    ///< the judged attempt's page, written as a file
    tryCure, ///< the judged attempt again, with the chosen remedy
    redo,    ///< back to before the chosen fault, or some seconds
    cut,     ///< the weld open, or closed again
    welder   ///< person who was chosen on the home page
};

} // namespace meltpool
