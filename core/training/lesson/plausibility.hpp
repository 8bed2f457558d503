// Warns of implausible values in a lesson and its torch path before the weld, though all of it can be read.
#pragma once

#include "core/training/lesson/lesson_folders.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// A sentence for each of these: the path never pulls the trigger in the lesson's time, or lasts longer than an hour;
/// for a weld lesson too: it is wholly outside the workpiece, away from the seam, on a pipe of another diameter, about
/// a thousand times too small or too large for the workpiece, or faster than any welder. `cut`: a person has chosen the
/// lesson's time, which may end before the trigger is pulled. Throws as makeWorkpiece().
std::vector<std::string> pathWarnings(const Lesson& lesson, bool cut = false);

/// "Torch path F is read as UTF-8, columns parted by commas, decimal point, times in s."; empty for moves, for a record
/// of this program and without a path. `file`: the path's name in the sentence.
std::string pathFormText(const std::filesystem::path& file, const TorchPath& path);

/// A sentence for each of these: the lesson has no title; its next lesson is not in the catalogue.
std::vector<std::string> lessonWarnings(const Lesson& lesson, const LessonFolders& catalogue);

} // namespace meltpool
