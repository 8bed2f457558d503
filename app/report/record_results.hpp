// The hand of a recorded attempt, read from its record alone: no metal is welded again.
#pragma once

#include "app/report/run_results.hpp"
#include "core/training/lesson/lesson.hpp"

#include <filesystem>

namespace meltpool {

/// Technique, score and arc of a record or a recording of `lesson`, by the measures used during the weld. There is no
/// weld in it, which a note says. Throws InputError for a file that is no record with an arc, or is one of another
/// lesson, and whatever takeTorch() throws.
RunResults readRecordResults(const std::filesystem::path& record, const Lesson& lesson);

} // namespace meltpool
