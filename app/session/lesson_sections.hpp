// A lesson's values as menus and the settings file group them.
#pragma once

#include "app/session/chart_values.hpp"
#include "app/session/parameter_section.hpp"
#include "core/training/lesson/lesson.hpp"

#include <vector>

namespace meltpool {

/// Conditions of an attempt.
struct AttemptParameters {
    bool forScore = false; ///< true: it starts only if the machine keeps up with the clock
};
ParameterList describe(AttemptParameters& parameters);

/// A lesson's values as the menus group them. They point into the lesson, which must outlive them unmoved; the defaults
/// are the lesson's values at construction.
struct LessonSections {
    explicit LessonSections(Lesson& lesson);

    AttemptParameters attempt; ///< shown with the start values
    ParameterSection start;    ///< choices before the metal is made
    ParameterSection view;
    ParameterSection surface;
    ParameterSection simulation;
    ChartValues chart; ///< makers' charts for plates and machine of the lesson

    std::vector<ParameterSection*> all() { return {&start, &view, &surface, &simulation}; }
    void restoreDefaults();
    /// Restores given values to the lesson's own, where they must not be changed now.
    void restoreGiven();
    /// True if the workpiece, or the classic metal's particles, differ from those at first. `lesson`: theirs.
    bool workpieceChanged(Lesson& lesson) const;
    /// True if a given, not chosen, setting of a weld's machine differs from the one at first.
    bool machineChanged(const Lesson& lesson) const;
};

/// Parameters that may change while the metal runs.
ParameterList liveParameters(ParameterList list);

} // namespace meltpool
