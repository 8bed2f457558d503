// Attempt files and run folders as commands take them.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace meltpool {

/// The lesson of a recorded attempt with its torch, values and changes, as takeTorch() gives them. `lesson`: a name of
/// the catalogue or a TOML file, empty for what the record names. Throws InputError for a file that is no attempt, and
/// what findLesson() and takeTorch() throw.
Lesson openAttempt(const std::filesystem::path& file, const std::string& lesson);

/// What only the pictures show of KEY=VALUE: camera, look and the surface's fineness. Throws InputError, naming what
/// there is, for another key.
void setView(Lesson& lesson, std::span<const std::string> assignments);

/// The values of WIDTHxHEIGHT and of the time between pictures (s), where they are not empty.
void setPictures(Lesson& lesson, const std::string& size, const std::string& every);

/// The folder of a run where `path` is one, or its result.json; empty for anything else.
std::filesystem::path runFolderOf(const std::filesystem::path& path);

} // namespace meltpool
