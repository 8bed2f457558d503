// A lesson's values as menus and the settings file group them.
#pragma once

#include "app/session/parameter_section.hpp"
#include "core/training/lesson/lesson.hpp"

#include <vector>

namespace meltpool {

/// How an attempt is made.
struct AttemptParameters {
    bool forScore = false; ///< it starts only where the machine keeps up with the clock
};
ParameterList describe(AttemptParameters& parameters);

/// A lesson's values as the menus group them. They point into the lesson, which must outlive them unmoved; the defaults
/// are what the lesson held when this was made.
struct LessonSections {
    explicit LessonSections(Lesson& lesson);

    AttemptParameters attempt; ///< shown with the start values
    ParameterSection start;    ///< what is chosen before the metal is made
    ParameterSection view;
    ParameterSection surface;
    ParameterSection simulation;

    std::vector<ParameterSection*> all() { return {&start, &view, &surface, &simulation}; }
    void restoreDefaults();
    /// Puts what the lesson gives back to the lesson's values, where it must not be changed now.
    void restoreGiven();
    /// The workpiece, or the classic metal's particles, are others than they were at first. `lesson`: theirs.
    bool workpieceChanged(Lesson& lesson) const;
    /// A setting of a weld's machine that is given, not chosen, is another than it was at first.
    bool machineChanged(const Lesson& lesson) const;
};

/// Those that may be changed while the metal runs.
ParameterList liveParameters(ParameterList list);

} // namespace meltpool
