// The lesson of a stored attempt, with the attempt as its demonstration.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <string>

namespace meltpool {

/// Lesson for a file. `file`: a record, a recording or, if `lesson` names one (of the catalogue, or a TOML file), also
/// a plain torch path. Empty `lesson`: the one that the file names. Throws InputError when the file or the lesson
/// cannot be used.
Lesson lessonOfAttempt(const std::filesystem::path& file, const std::string& lesson = {});

} // namespace meltpool
