#include "app/commands/named_lesson.hpp"

#include "app/platform/say.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson/plausibility.hpp"

#include <cstdio>
#include <utility>

namespace meltpool {

namespace {

constexpr size_t kMostBytes = 1000; ///< bytes of a sentence

} // namespace

Lesson namedLesson(const std::string& name, const LessonFolders& folders) {
    Lesson lesson = findLesson(name, folders);
    for (const NamedLesson& each : folders.named(name))
        if (!each.fault.empty()) std::fprintf(stderr, "meltpool: left out: %s\n", each.fault.c_str());
    return lesson;
}

void warn(const std::string& sentence) {
    std::fprintf(stderr, "meltpool: warning: %s\n", printable(sentence, kMostBytes).c_str());
}

void tellForm(const std::filesystem::path& file, const TorchPath& path) {
    if (const std::string text = pathFormText(file, path); !text.empty()) say("%s\n", text.c_str());
}

std::vector<std::string> tellWarnings(const Lesson& lesson, bool cut) {
    std::vector<std::string> sentences = lessonWarnings(lesson, LessonFolders::ofUser());
    for (std::string& sentence : pathWarnings(lesson, cut))
        sentences.push_back(std::move(sentence));
    for (const std::string& sentence : sentences)
        warn(sentence);
    return sentences;
}

} // namespace meltpool
