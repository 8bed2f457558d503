// The lesson that a kept attempt was made in, with the attempt as its demonstration.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <string>

namespace meltpool {

/// `file`: a record, a recording or, where `lesson` names one (of the catalogue, or a TOML file), also a plain torch
/// path. Empty `lesson`: the one that the file names. Throws InputError where the file or the lesson cannot be used.
Lesson lessonOfAttempt(const std::filesystem::path& file, const std::string& lesson = {});

} // namespace meltpool
