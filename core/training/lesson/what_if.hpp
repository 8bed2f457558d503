// What if: one thing of an attempt changed, be it of the hand or of the lesson's values.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meltpool {

/// How a path is changed. All at rest: the path as it is.
struct PathChange {
    double speed = 1; ///< times as fast; the whole path with its pauses and swings
    /// m/s that the mean travel speed becomes instead of `speed` times as fast; see PathChange::resolved().
    std::optional<double> travelSpeed = {};
    double farther = 0;     ///< m, back along the torch's own axis, while the arc burns
    double workAngle = 0;   ///< rad more, signs as TechniqueQuantity has them
    double travelAngle = 0; ///< rad more, the same
    double stillness = 0;   ///< 0..1, share of the tremor that is taken away

    /// The same with `speed` in place of `travelSpeed`, for an attempt whose mean travel speed was `mean` m/s. Throws
    /// InputError where that is no speed to begin from.
    PathChange resolved(std::optional<double> mean) const;
};

struct WhatIf {
    PathChange path;
    std::vector<std::pair<std::string, std::string>> values; ///< of the lesson, key and text
    std::vector<std::pair<std::string, std::string>> asked;  ///< all, as they were asked for

    /// "speed=0.8, voltage=25"; "nothing" where nothing was asked for.
    std::string text() const;
};

/// Reads KEY=VALUE for a lesson. KEY is one of
///
///     speed          a factor (0.8), or the mean travel speed that is wanted (6mm/s)
///     arc_length     mm longer than it was: of GTAW and covered electrodes
///     stick_out      mm longer than it was: of all other processes
///     work_angle     degrees more
///     travel_angle   degrees more, positive towards a push
///     stillness      0 as it was .. 1 without tremor
///     wire_feed, gap short for wire_feed_m_min and gap_mm
///
/// or any value of the lesson's metal and process. Throws InputError, naming what may be changed, for another key, one
/// that is given twice, and a value that does not fit.
WhatIf readWhatIf(std::span<const std::string> wishes, const Lesson& lesson);

/// Makes the lesson the changed one: the values, which then hold from the first step to the last, and recorded changes
/// and events at the steps of a path `speed` times as fast. What the record says of its end no longer applies.
void takeWhatIf(Lesson& lesson, const WhatIf& whatIf, double speed);

} // namespace meltpool
