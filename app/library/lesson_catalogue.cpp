#include "app/library/lesson_catalogue.hpp"

#include "core/base/error.hpp"
#include "core/base/words.hpp"
#include "core/training/lesson/lesson.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace meltpool {

namespace {

/// Place of a lesson's process in the list: most trainees begin with wire and gas.
int processRank(const Lesson& lesson) {
    if (lesson.model != LessonModel::Weld) return 5;
    switch (traitsOf(lesson.process).torch) {
    case TorchShape::wireTorch:
        return 0;
    case TorchShape::electrodeHolder:
        return 1;
    case TorchShape::tungstenTorch:
        return 2;
    case TorchShape::iron:
        return 3;
    case TorchShape::burner:
        return 4;
    }
    return kNoProcess;
}

/// Number of each lesson in the chains of next ones: a lesson's is smaller than its next one's, unless they go round.
std::map<std::string, int> chainNumbers(const std::vector<CataloguedLesson>& lessons) {
    std::map<std::string, const CataloguedLesson*> byKey;
    std::set<std::string> following;
    for (const CataloguedLesson& lesson : lessons) {
        byKey.emplace(lesson.key, &lesson);
        if (!lesson.next.empty()) following.insert(lesson.next);
    }
    std::map<std::string, int> numbers;
    const auto number = [&](const CataloguedLesson* lesson) {
        while (lesson != nullptr && numbers.try_emplace(lesson->key, static_cast<int>(numbers.size())).second) {
            const auto next = byKey.find(lesson->next);
            lesson = next != byKey.end() ? next->second : nullptr;
        }
    };
    for (const CataloguedLesson& lesson : lessons)
        if (following.count(lesson.key) == 0) number(&lesson);
    for (const CataloguedLesson& lesson : lessons)
        number(&lesson);
    return numbers;
}

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
        listed.process = processRank(lesson);
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
    const std::map<std::string, int> chain = chainNumbers(lessons);
    const auto rank = [&](const CataloguedLesson& lesson) {
        return std::tuple(lesson.origin, lesson.process, lesson.level > 0 ? lesson.level : kMostLevel + 1,
                          chain.at(lesson.key));
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
