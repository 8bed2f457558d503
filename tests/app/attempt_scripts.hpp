// Attempts that a script leads through a session without a window: every process, plates, tees, a cube and a bridge,
// steady and unsteady hands, with all that may happen on the way.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace meltpool::test {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A setting that is turned while the metal is welded.
struct ScriptedChange {
    double time = 0; ///< s of the metal
    std::string key;
    std::string value;
};

struct AttemptScript {
    std::string name;
    std::string process; ///< "flame", "iron", "gtaw", "rod" (GTAW with one), "gmaw" or "smaw"
    std::string piece;   ///< "plate", "tee", "cube" or "bridge"
    /// "still", "along", "weave", "circle", "dabs" (with pauses of the trigger), "shaky"; "desk": mouse and keys
    std::string hand;
    double seconds = 2; ///< of the metal
    std::vector<ScriptedChange> changes = {};
    double lost = kNever;  ///< s of the metal from which the torch is out of sight for a while
    double pause = kNever; ///< s, when the person looks at it from elsewhere
    double redo = kNever;  ///< s, when the person goes back
};

/// Twenty of them.
std::span<const AttemptScript> attemptScripts();

/// The lesson that it is welded in: one of the catalogue on a small and hot workpiece.
Lesson lessonOf(const AttemptScript& script);

/// Welds it in a session that records into `folder`; the recording.
std::filesystem::path recordAttempt(const AttemptScript& script, const std::filesystem::path& folder);

} // namespace meltpool::test
