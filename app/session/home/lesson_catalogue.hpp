// The lessons as the home page lists them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

struct CataloguedLesson {
    std::string key;
    std::filesystem::path file;
    std::string title;             ///< the key where the file is at fault
    std::string text;              ///< what the trainee is asked to do
    std::string fault;             ///< why the lesson cannot be used, a sentence; empty: it can
    std::string next;              ///< key of the lesson that follows; empty: none
    int level = 0;                 ///< see Lesson::level
    std::filesystem::path picture; ///< need not exist
};

/// Every lesson of a folder: the easiest first, those of a level by name, those without a level and faulty ones last.
/// Throws InputError where the folder cannot be read.
std::vector<CataloguedLesson> readCatalogue(const std::filesystem::path& folder);

/// "Level 2 of 5"; empty for a lesson without a level.
std::string levelText(int level);

} // namespace meltpool
