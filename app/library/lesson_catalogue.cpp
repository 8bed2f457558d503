#include "app/library/lesson_catalogue.hpp"

#include "core/base/error.hpp"
#include "core/base/words.hpp"
#include "core/training/lesson/lesson.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

namespace {

CataloguedLesson readOne(const NamedLesson& named) {
    CataloguedLesson listed;
    listed.key = listed.title = named.key;
    listed.file = named.file;
    listed.origin = named.origin;
    listed.fault = named.fault;
    listed.taken = !named.fault.empty();
    if (listed.taken) return listed;
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

std::vector<CataloguedLesson> readCatalogue(const LessonFolders& folders, std::vector<std::string>& faults) {
    std::vector<CataloguedLesson> lessons;
    for (const NamedLesson& named : folders.list(&faults))
        lessons.push_back(readOne(named));
    const auto rank = [](const CataloguedLesson& lesson) {
        return std::pair(lesson.origin, lesson.level > 0 ? lesson.level : kMostLevel + 1);
    };
    std::stable_sort(lessons.begin(), lessons.end(),
                     [&](const CataloguedLesson& a, const CataloguedLesson& b) { return rank(a) < rank(b); });
    return lessons;
}

std::string shortFault(const CataloguedLesson& lesson) {
    const std::string folder = (lesson.file.parent_path() / "").string();
    std::string text = lesson.fault;
    for (size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
        text.erase(at, folder.size());
    return text;
}

std::string levelText(int level) {
    if (level <= 0) return {};
    return phrase("library.level", {{"level", std::to_string(level)}, {"levels", std::to_string(kMostLevel)}});
}

} // namespace meltpool
