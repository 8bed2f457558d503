// What a person should know of a lesson and its torch path before it is welded, though all of it can be read.
#pragma once

#include "core/training/lesson/lesson_folders.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// A sentence for each of these: the path never pulls the trigger in the lesson's time, or lasts longer than an hour;
/// of a weld lesson too that it lies wholly outside the workpiece, away from the seam, on a pipe of another diameter,
/// that it is about a thousand times too small or too large for the workpiece, or that it hurries as no welder can.
/// `cut`: a person has chosen the lesson's time, which may end before the trigger is pulled. Throws as makeWorkpiece().
std::vector<std::string> pathWarnings(const Lesson& lesson, bool cut = false);

/// "Torch path F is read as UTF-8, columns parted by commas, decimal point, times in s."; empty for moves, for a record
/// of this program and without a path. `file`: the name that the sentence gives it.
std::string pathFormText(const std::filesystem::path& file, const TorchPath& path);

/// A sentence for each of these: the lesson has no title, and the lesson that it names as the next is not in the
/// catalogue.
std::vector<std::string> lessonWarnings(const Lesson& lesson, const LessonFolders& catalogue);

} // namespace meltpool
