// The lessons as the home page lists them.
#pragma once

#include "core/training/lesson/lesson_folders.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

struct CataloguedLesson {
    std::string key;
    std::filesystem::path file;
    LessonOrigin origin = LessonOrigin::shipped;
    bool taken = false;            ///< the key means another lesson: this one cannot be used until it is renamed
    std::string title;             ///< the key where the file is at fault
    std::string text;              ///< what the trainee is asked to do
    std::string fault;             ///< why the lesson cannot be used, a sentence; empty: it can
    std::string next;              ///< key of the lesson that follows; empty: none
    int level = 0;                 ///< see Lesson::level
    std::filesystem::path picture; ///< need not exist
};

/// Every lesson of the folders, group by group: in each the easiest first, those of a level by name, those without a
/// level and faulty ones last. `faults` gets a sentence for each folder that cannot be read. Throws InputError where
/// the shipped lessons cannot be read.
std::vector<CataloguedLesson> readCatalogue(const LessonFolders& folders, std::vector<std::string>& faults);

/// The fault as a list shows it: the lesson's own folder is left out.
std::string shortFault(const CataloguedLesson& lesson);

/// "Level 2 of 5"; empty for a lesson without a level.
std::string levelText(int level);

} // namespace meltpool
