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

/// Says pathFormText() where there is one.
void tellForm(const std::filesystem::path& file, const TorchPath& path);

/// Warns of lessonWarnings() and pathWarnings() and answers them, for the result. `cut`: the run's time was asked for.
std::vector<std::string> tellWarnings(const Lesson& lesson, bool cut = false);

} // namespace meltpool
