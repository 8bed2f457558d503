// Scripted attempts in a session without a window, for every process, several workpieces, steady and unsteady hands,
// and all events of an attempt.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace meltpool::test {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A setting that changes during the weld.
struct ScriptedChange {
    double time = 0; ///< s of simulated time
    std::string key;
    std::string value;
};

struct AttemptScript {
    std::string name;
    std::string process; ///< "flame", "iron", "gtaw", "rod" (GTAW with a filler rod), "gmaw" or "smaw"
    std::string piece;   ///< "plate", "tee", "cube" or "bridge"
    /// "still", "along", "weave", "circle", "dabs" (with pauses of the trigger), "shaky"; "desk" is mouse and keys.
    std::string hand;
    double seconds = 2; ///< simulated time
    std::vector<ScriptedChange> changes = {};
    double lost = kNever;  ///< s of simulated time at which the torch leaves the trackers' sight for a while
    double pause = kNever; ///< s, time at which the person pauses and looks from elsewhere
    double redo = kNever;  ///< s, time at which the person goes back
};

/// Returns the twenty scripted attempts.
std::span<const AttemptScript> attemptScripts();

/// Returns the lesson of an attempt: one of the catalogue on a small and hot workpiece.
Lesson lessonOf(const AttemptScript& script);

/// Welds the attempt in a session that records into `folder`. Returns the path of the recording.
std::filesystem::path recordAttempt(const AttemptScript& script, const std::filesystem::path& folder);

} // namespace meltpool::test
