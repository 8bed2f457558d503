#include "core/training/recorded_attempt.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr std::string_view kFirstLine = "# meltpool record 1";

/// Cuts the first word off `text`.
std::string_view takeWord(std::string_view& text) {
    const size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text = trimText(text.substr(end));
    return word;
}

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file) { attempt_.file = file; }

    std::optional<RecordedAttempt> read() {
        const std::string text = readTextFile(attempt_.file);
        if (!text.starts_with(kFirstLine)) return std::nullopt;
        for (size_t start = 0; start < text.size();) { // line by line: a record of hours is large
            const size_t end = std::min(text.find('\n', start), text.size());
            const std::string_view content = trimText(std::string_view(text).substr(start, end - start));
            start = end + 1;
            ++line_;
            if (content.empty()) continue;
            if (!content.starts_with('#'))
                ++rows_;
            else if (line_ > 1)
                readComment(trimText(content.substr(1)));
        }
        attempt_.rows = rows_ > 0 ? rows_ - 1 : 0; // the first is the header
        return std::move(attempt_);
    }

  private:
    void readComment(std::string_view text) {
        const std::string_view word = takeWord(text);
        if (word == "lesson") attempt_.lesson = text;
        if (word == "driver") attempt_.driver = text;
        if (word == "value") attempt_.values.push_back(assignment(text));
        if (word == "set") attempt_.changes.push_back(assignment(text));
        if (word == "event") addEvent(text);
        if (word == "ended") attempt_.ended = text;
        if (word == "state_hash") attempt_.stateHash = text;
        if (word == "real_time") attempt_.realTime = ratio(text);
    }

    void addEvent(std::string_view text) {
        const std::string_view name = takeWord(text);
        if (name != "torch" && name != "samples") return;
        attempt_.events.push_back({stepsBefore(), std::string(name), std::string(text)});
    }

    size_t stepsBefore() const { return rows_ > 0 ? rows_ - 1 : 0; }

    RecordedChange assignment(std::string_view text) const {
        RecordedChange change;
        change.key = takeWord(text);
        change.value = text;
        change.steps = stepsBefore();
        change.line = line_;
        if (change.key.empty() || change.value.empty())
            throw InputError(attempt_.file, line_, "has no value; expected '# set KEY VALUE' or '# value KEY VALUE'");
        return change;
    }

    double ratio(std::string_view text) const {
        const auto value = parseDouble(text);
        if (!value || !(*value >= 0) || *value > 1e6)
            throw InputError(attempt_.file, line_, "is no ratio; expected '# real_time' and a number from 0 on");
        return *value;
    }

    RecordedAttempt attempt_;
    int line_ = 0;
    size_t rows_ = 0;
};

std::string placeOf(const RecordedAttempt& attempt, const RecordedChange& change) {
    return attempt.file.string() + ":" + std::to_string(change.line);
}

} // namespace

std::optional<RecordedAttempt> readRecordedAttempt(const std::filesystem::path& file) {
    return Reader(file).read();
}

std::optional<bool> sameEnd(const RecordedAttempt& attempt, size_t steps, std::uint64_t stateHash) {
    if (attempt.stateHash.empty() || steps != attempt.rows) return std::nullopt;
    return attempt.stateHash == formatHexadecimal(stateHash);
}

void repeatAttempt(Lesson& lesson, const RecordedAttempt& attempt) {
    if (attempt.lesson != lesson.key)
        throw InputError(attempt.file, 2,
                         "is a record of lesson '" + attempt.lesson + "'; expected one of '" + lesson.key +
                             "', or a plain torch path, whose first line is not '" + std::string(kFirstLine) + "'");
    Lesson checked = lesson;
    for (const RecordedChange& value : attempt.values)
        checked.set(value.key, value.value, placeOf(attempt, value));
    Lesson later = checked;
    for (const RecordedChange& change : attempt.changes)
        later.set(change.key, change.value, placeOf(attempt, change));
    checked.recorded = attempt;
    lesson = std::move(checked);
}

void takeTorch(Lesson& lesson, const std::filesystem::path& file) {
    lesson.torchFile = file;
    lesson.torch = TorchPath::read(file);
    if (file.extension() != ".csv") return;
    const auto attempt = readRecordedAttempt(file);
    if (!attempt) return;
    repeatAttempt(lesson, *attempt);
    lesson.run.seconds = static_cast<float>(lesson.torch.duration());
}

} // namespace meltpool
