// Lessons by name for the commands, with warnings for the person.
#pragma once

#include "core/training/lesson/lesson_folders.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// Calls findLesson() and lists on standard error the files of that name that are left out.
Lesson namedLesson(const std::string& name, const LessonFolders& folders);

/// Prints one line on standard error.
void warn(const std::string& sentence);

/// Prints pathFormText() if there is one.
void tellForm(const std::filesystem::path& file, const TorchPath& path);

/// Prints lessonWarnings() and pathWarnings() and returns them, for the result. `cut`: the person chose the run's time.
std::vector<std::string> tellWarnings(const Lesson& lesson, bool cut = false);

} // namespace meltpool
