// `meltpool lessons`: the list of lessons, or the values of one.
#include "app/commands/commands.hpp"
#include "app/commands/named_lesson.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <optional>
#include <utility>

namespace meltpool {

namespace {

using Json = nlohmann::ordered_json;

/// Note as a sentence: notes are written as fragments or sentences, and a list shows sentences.
std::string asSentence(std::string_view note) {
    std::string text = capitalised(note);
    if (text.empty()) return text;
    if (text.back() != '.') text += '.';
    return text;
}

/// Text from a file or a person, made safe for the terminal.
std::string shown(const std::string& text) {
    constexpr size_t kMostBytes = 1000;
    return printable(text, kMostBytes);
}

/// Lesson as it was read, or the reason why its file cannot be used.
struct ReadFile {
    std::optional<Lesson> lesson;
    std::string fault;
};

ReadFile read(const NamedLesson& named) {
    if (!named.fault.empty()) return {{}, named.fault};
    try {
        return {readLesson(named.file), {}};
    } catch (const InputError& error) {
        return {{}, error.what()};
    }
}

/// Prints one line of the list.
void printLesson(const NamedLesson& named, std::vector<std::string>& faults) {
    const ReadFile file = read(named);
    if (file.lesson)
        std::printf("%-20s %5.0f s  %s\n", shown(named.key).c_str(), static_cast<double>(file.lesson->run.seconds),
                    shown(file.lesson->title).c_str());
    else
        std::printf("%-20s %7s  (cannot be used, see below)\n", shown(named.key).c_str(), "-");
    if (!file.fault.empty()) faults.push_back(file.fault);
}

/// Entry of a lesson in the JSON list.
Json lessonJson(const NamedLesson& named, std::vector<std::string>& faults) {
    Json json{{"name", named.key}, {"origin", nameOf(named.origin)}, {"file", named.file.string()}};
    const ReadFile file = read(named);
    json["fault"] = file.fault;
    if (!file.fault.empty()) faults.push_back(file.fault);
    if (!file.lesson) return json;
    json["title"] = file.lesson->title;
    json["text"] = file.lesson->text;
    json["level"] = file.lesson->level > 0 ? Json(file.lesson->level) : Json();
    json["next"] = file.lesson->next;
    json["model"] = file.lesson->model == LessonModel::Weld ? "weld" : "classic";
    // By its shortest text: the float itself would be 0.6000000238.
    json["seconds"] = parseDouble(formatNumber(file.lesson->run.seconds)).value_or(0);
    return json;
}

Json parameterJson(const Parameter& p) {
    Json json{{"key", p.key}, {"value", parameterText(p)}, {"unit", p.unit}};
    const bool number = std::holds_alternative<float*>(p.value) || std::holds_alternative<glm::vec3*>(p.value) ||
                        (std::holds_alternative<int*>(p.value) && p.choices.empty());
    json["minimum"] = number ? Json(p.minimum) : Json();
    json["maximum"] = number ? Json(p.maximum) : Json();
    json["choices"] = std::vector<std::string_view>(p.choices.begin(), p.choices.end());
    json["only_at_start"] = p.onlyAtStart;
    json["note"] = asSentence(p.note);
    return json;
}

void printJson(const Json& json) {
    std::printf("%s\n", json.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

/// Prints the heading of a folder's lessons.
void printHeading(const LessonFolder& folder) {
    std::printf("%s (%s):\n", std::string(headingOf(folder.origin)).c_str(), shown(folder.path.string()).c_str());
}

void printGroups(const LessonFolders& folders, const std::vector<NamedLesson>& lessons,
                 std::vector<std::string>& faults) {
    const bool grouped = !lessons.empty() && lessons.front().origin != lessons.back().origin;
    for (const LessonFolder& folder : folders.folders()) {
        bool headed = !grouped;
        for (const NamedLesson& named : lessons) {
            if (named.origin != folder.origin) continue;
            if (!std::exchange(headed, true)) printHeading(folder);
            printLesson(named, faults);
        }
    }
}

} // namespace

bool listLessons(bool json) {
    const LessonFolders folders = LessonFolders::ofUser();
    std::vector<std::string> faults;
    const std::vector<NamedLesson> lessons = folders.list(&faults);
    if (json) {
        Json list = Json::array();
        for (const NamedLesson& named : lessons)
            list.push_back(lessonJson(named, faults));
        printJson(list);
    } else {
        printGroups(folders, lessons, faults);
    }
    std::fflush(stdout); // the faults come below the list
    for (const std::string& fault : faults)
        std::fprintf(stderr, "meltpool: %s\n", fault.c_str());
    return faults.empty();
}

void listParameters(const std::string& name, bool json) {
    Lesson lesson = namedLesson(name, LessonFolders::ofUser());
    if (!json) tellForm(lesson.torchFile, lesson.torch);
    tellWarnings(lesson);
    if (json) {
        Json list = Json::array();
        for (const Parameter& p : lesson.parameters())
            list.push_back(parameterJson(p));
        return printJson(list);
    }
    for (const Parameter& p : lesson.parameters())
        std::printf("%-20s %-12s %s%s. %s\n", std::string(p.key).c_str(), shown(parameterText(p)).c_str(),
                    expectation(p).c_str(), p.onlyAtStart ? ", at the start only" : "", asSentence(p.note).c_str());
}

} // namespace meltpool
