// The list of lessons for the home page.
#pragma once

#include "core/training/lesson/lesson_folders.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// Rank of a lesson whose process is unknown.
inline constexpr int kNoProcess = 100;

struct CataloguedLesson {
    std::string key;
    std::filesystem::path file;
    LessonOrigin origin = LessonOrigin::shipped;
    bool taken = false;            ///< another lesson has this key: this one cannot be used until it is renamed
    std::string title;             ///< the key if the file is faulty
    std::string text;              ///< task for the trainee
    std::string fault;             ///< sentence that says why the lesson cannot be used; empty: it can
    std::string next;              ///< key of the next lesson; empty: none
    int level = 0;                 ///< see Lesson::level
    int process = kNoProcess;      ///< rank of its process in the list
    std::filesystem::path picture; ///< need not exist
};

/// Lessons of the folders, group by group: in each those of one process after another, from wire and gas to the flame
/// on the classic metal; of a process the easiest first, those without a level last; of a level a lesson before its
/// next one, else by name. Faulty lessons come last. `faults` gets a sentence for each folder that cannot be read.
/// Throws InputError when the shipped lessons cannot be read.
std::vector<CataloguedLesson> readCatalogue(const LessonFolders& folders, std::vector<std::string>& faults);

/// Fault for a list: without the lesson's own folder.
std::string shortFault(const CataloguedLesson& lesson);

/// Text "Level 2 of 5"; empty for a lesson without a level.
std::string levelText(int level);

} // namespace meltpool
