// Lessons as the commands take them: by name, with a word about what a person should know of them.
#pragma once

#include "core/training/lesson/lesson_folders.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// findLesson(); tells on standard error which files of the same name are left out.
Lesson namedLesson(const std::string& name, const LessonFolders& folders);

/// One line on standard error.
void warn(const std::string& sentence);

/// How a torch path's table was understood, where it is not one of this program's own.
void tellForm(const std::filesystem::path& file, const TorchPath& path);

/// What a person should know before the run: told here, and again in the result. `cut`: the run's time was asked for.
std::vector<std::string> tellWarnings(const Lesson& lesson, bool cut = false);

} // namespace meltpool
