// Repeats an attempt with one thing changed, in the hand or in the lesson's values.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meltpool {

/// Change of a path. The default leaves the path unchanged.
struct PathChange {
    double speed = 1; ///< factor of speed; for the whole path with its pauses and swings
    /// Wanted mean travel speed, m/s, instead of `speed`; see PathChange::resolved().
    std::optional<double> travelSpeed = {};
    double farther = 0;     ///< m, back along the torch's own axis, while the arc burns
    double workAngle = 0;   ///< rad added, signs as in TechniqueQuantity
    double travelAngle = 0; ///< rad added, signs as in TechniqueQuantity
    double stillness = 0;   ///< 0..1, removed share of the tremor

    /// The change with `speed` in place of `travelSpeed`, for an attempt with mean travel speed `mean` (m/s). Throws
    /// InputError if `mean` is unknown or not a usable speed.
    PathChange resolved(std::optional<double> mean) const;
};

struct WhatIf {
    PathChange path;
    std::vector<std::pair<std::string, std::string>> values; ///< values of the lesson, key and text
    std::vector<std::pair<std::string, std::string>> asked;  ///< all wishes, as entered

    /// "speed=0.8, voltage=25"; "nothing" without a wish.
    std::string text() const;
};

/// Reads KEY=VALUE for a lesson. KEY is one of
///
///     speed          a factor (0.8), or the wanted mean travel speed (6mm/s)
///     arc_length     mm added: for GTAW and covered electrodes
///     stick_out      mm added: for all other processes
///     work_angle     degrees added
///     travel_angle   degrees added, positive towards a push
///     stillness      0 unchanged .. 1 without tremor
///     wire_feed, gap short for wire_feed_m_min and gap_mm
///
/// or any value of the lesson's metal and process. Throws InputError, naming the allowed keys, for another key, a key
/// given twice, and a value that does not fit.
WhatIf readWhatIf(std::span<const std::string> wishes, const Lesson& lesson);

/// Changes the lesson: its values hold from the first step to the last, and recorded changes and events move to the
/// steps of a path `speed` times as fast. The recorded end no longer applies.
void takeWhatIf(Lesson& lesson, const WhatIf& whatIf, double speed);

} // namespace meltpool
