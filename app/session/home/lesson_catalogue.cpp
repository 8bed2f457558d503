#include "app/session/home/lesson_catalogue.hpp"

#include "core/base/error.hpp"
#include "core/training/lesson.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

namespace {

CataloguedLesson readOne(const std::filesystem::path& folder, const std::string& name) {
    CataloguedLesson listed;
    listed.key = listed.title = name;
    listed.file = folder / (name + ".toml");
    try {
        const Lesson lesson = readLesson(listed.file);
        listed.title = lesson.title;
        listed.text = lesson.text;
        listed.next = lesson.next;
        listed.level = lesson.level;
        listed.picture = lesson.listPicture;
    } catch (const InputError& fault) {
        listed.fault = fault.what();
    }
    return listed;
}

} // namespace

std::vector<CataloguedLesson> readCatalogue(const std::filesystem::path& folder) {
    std::vector<CataloguedLesson> lessons;
    for (const std::string& name : lessonNames(folder))
        lessons.push_back(readOne(folder, name));
    const auto rank = [](const CataloguedLesson& lesson) { return lesson.level > 0 ? lesson.level : kMostLevel + 1; };
    std::stable_sort(lessons.begin(), lessons.end(),
                     [&](const CataloguedLesson& a, const CataloguedLesson& b) { return rank(a) < rank(b); });
    return lessons;
}

std::string levelText(int level) {
    if (level <= 0) return {};
    return "Level " + std::to_string(level) + " of " + std::to_string(kMostLevel);
}

} // namespace meltpool
