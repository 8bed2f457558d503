#include "core/training/attempt/attempt_head.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/record_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace meltpool {

namespace {

/// A damaged file may claim any number; no trainee makes this many attempts.
constexpr std::int64_t kMostAttempts = 1'000'000;

struct TextLine {
    std::string_view word;
    std::string AttemptHead::*text;
};
constexpr std::array<TextLine, 9> kTexts{{{"lesson", &AttemptHead::lesson},
                                          {"lesson_file", &AttemptHead::lessonFile},
                                          {"lesson_hash", &AttemptHead::lessonHash},
                                          {"person", &AttemptHead::person},
                                          {"person_id", &AttemptHead::personId},
                                          {"date", &AttemptHead::date},
                                          {"utc", &AttemptHead::utc},
                                          {"program", &AttemptHead::program},
                                          {"driver", &AttemptHead::driver}}};

} // namespace

void appendHeadLines(std::string& text, std::string_view prefix, const AttemptHead& head) {
    const auto known = [&](std::string_view word, const std::string& value) {
        if (!value.empty()) appendRecordLine(text, prefix, word, value, {});
    };
    appendRecordLine(text, prefix, "lesson", head.lesson, {});
    known("lesson_file", head.lessonFile);
    known("lesson_hash", head.lessonHash);
    appendRecordLine(text, prefix, "attempt", std::to_string(head.attempt), {});
    known("person", head.person);
    known("person_id", head.personId);
    known("date", head.date);
    known("utc", head.utc);
    appendRecordLine(text, prefix, "program", head.program, {});
    appendRecordLine(text, prefix, "driver", head.driver, {});
}

void appendStartValues(std::string& text, std::string_view prefix, const AttemptHead& head) {
    for (const auto& [key, value] : head.values)
        appendRecordLine(text, prefix, "value", key, value);
    for (const std::string& key : head.chosen)
        appendRecordLine(text, prefix, "chosen", key, {});
}

bool readHeadLine(AttemptHead& head, std::string_view word, std::string_view text) {
    for (const TextLine& line : kTexts)
        if (word == line.word) {
            head.*line.text = text;
            return true;
        }
    if (word == "chosen") {
        head.chosen.emplace_back(text);
        return true;
    }
    if (word != "attempt") return false;
    const auto number = parseInteger(text);
    if (!number || *number < 0) throw InputError("the attempt's number is not a whole number; expected 1 or more");
    head.attempt = static_cast<int>(std::min<std::int64_t>(*number, kMostAttempts));
    return true;
}

} // namespace meltpool
