// Attempt files and run folders as arguments of commands.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace meltpool {

/// Lesson of a recorded attempt with its torch, values and changes, as takeTorch() gives them. `lesson`: a name of the
/// catalogue or a TOML file, empty for the one that the record names. Throws InputError for a file that is no attempt,
/// and whatever findLesson() and takeTorch() throw.
Lesson openAttempt(const std::filesystem::path& file, const std::string& lesson);

/// Sets KEY=VALUE that affects only the pictures: camera, look and the surface's fineness. Throws InputError, naming
/// the keys, for another key.
void setView(Lesson& lesson, std::span<const std::string> assignments);

/// Sets the values of WIDTHxHEIGHT and of the time between pictures (s), if they are not empty.
void setPictures(Lesson& lesson, const std::string& size, const std::string& every);

/// Folder of a run if `path` is one, or its result.json; empty for anything else.
std::filesystem::path runFolderOf(const std::filesystem::path& path);

} // namespace meltpool
