#include "core/training/lesson/recorded_attempt.hpp"

#include "core/base/error.hpp"
#include "core/base/table_reader.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/record_text.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/weld/process/arc.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

/// Cuts the first word off `text`.
std::string_view takeWord(std::string_view& text) {
    const size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text = trimText(text.substr(end));
    return word;
}

bool spoilsScore(std::string_view event) {
    return event == "torch" || event == "samples";
}

/// Time the file was last written; empty if the system does not know it, as for a pipe.
std::string fileDate(const std::filesystem::path& file) {
    std::error_code failure;
    const auto written = std::filesystem::last_write_time(file, failure);
    if (failure || !std::filesystem::is_regular_file(file, failure)) return {};
    const auto moment = std::chrono::file_clock::to_sys(written);
    return formatDate(std::chrono::time_point_cast<std::chrono::system_clock::duration>(moment));
}

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file) {
        attempt_.file = file;
        attempt_.head.date = fileDate(file);
    }

    std::optional<RecordedAttempt> read() {
        TableReader table(readTextFile(attempt_.file), attempt_.file, isTorchColumn);
        bool first = true;
        for (TableReader::Item item = table.next(); item != TableReader::Item::end; item = table.next()) {
            if (first && (item != TableReader::Item::comment || !table.comment().starts_with(kRecordFirstLine)))
                return std::nullopt;
            line_ = table.line();
            if (item == TableReader::Item::row)
                addRow(table);
            else if (!std::exchange(first, false))
                readComment(trimText(table.comment().substr(1)));
        }
        if (first) return std::nullopt;
        attempt_.rows = rows_;
        return std::move(attempt_);
    }

  private:
    void addRow(TableReader& table) {
        ++rows_;
        if (attempt_.firstArc) return;
        const auto cell = [&](std::string_view name) -> std::string_view {
            const auto& columns = table.columns();
            const auto place = static_cast<size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin());
            return place < table.cells().size() ? table.cells()[place] : std::string_view();
        };
        const std::string_view arc = cell("arc_state");
        if (arc.empty() || arc == arcActionName(ArcAction::out)) return;
        attempt_.firstArc = parseDouble(cell("time_s"));
        arcRow_ = rows_;
    }

    void readComment(std::string_view text) {
        const std::string_view word = takeWord(text);
        if (isHeadLine(word, text)) return;
        if (word == "value") attempt_.values.push_back(assignment(text));
        if (word == "set") attempt_.changes.push_back(assignment(text));
        if (word == "event") addEvent(text);
        if (word == "ended") attempt_.ended = text;
        if (word == "state_hash") attempt_.stateHash = text;
        if (word == "real_time") attempt_.realTime = ratio(text);
    }

    /// The file's date remains the shown one: a record's own date is of its start.
    bool isHeadLine(std::string_view word, std::string_view text) {
        if (word == "date") return true;
        try {
            return readHeadLine(attempt_.head, word, text);
        } catch (const InputError& fault) {
            throw InputError(attempt_.file, line_, fault.what());
        }
    }

    void addEvent(std::string_view text) {
        const std::string_view name = takeWord(text);
        if (name == "redo") return goBack(text);
        if (name == "begun_at")
            throw InputError(attempt_.file, line_,
                             "begins in the middle of an attempt, like 'meltpool replay --seek'; expected a record "
                             "from the first step on");
        (spoilsScore(name) ? attempt_.events : attempt_.notes)
            .push_back({stepsBefore(), std::string(name), std::string(text)});
    }

    /// Drops entries after this step: they belong to the abandoned branch.
    void goBack(std::string_view text) {
        const auto step = parseDouble(text);
        if (!step || *step != std::floor(*step) || *step < 0 || *step > static_cast<double>(stepsBefore()))
            throw InputError(attempt_.file, line_,
                             "goes back to a step that is not there; expected '# event redo' and a whole number from 0 "
                             "to " +
                                 std::to_string(stepsBefore()));
        const auto steps = static_cast<size_t>(*step);
        attempt_.notes.push_back({stepsBefore(), "redo", std::string(text)});
        rows_ = steps;
        if (arcRow_ > steps) attempt_.firstArc.reset();
        std::erase_if(attempt_.changes, [&](const RecordedChange& change) { return change.steps > steps; });
        std::erase_if(attempt_.events, [&](const RecordedEvent& event) {
            return event.name == "samples" ? event.steps >= steps : event.steps > steps; // these samples are missing
                                                                                         // before the next step
        });
        ++attempt_.redone;
    }

    size_t stepsBefore() const { return rows_; }

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
            throw InputError(attempt_.file, line_, "is not a ratio; expected '# real_time' and a number from 0");
        return *value;
    }

    RecordedAttempt attempt_;
    int line_ = 0;
    size_t rows_ = 0;
    size_t arcRow_ = 0; ///< row of attempt_.firstArc
};

RecordedChange changeOf(const RecordingNote& note) {
    return {static_cast<size_t>(note.steps), note.name, note.value, static_cast<int>(note.frame), note.seconds};
}

/// Converts the frames of a recording.
RecordedAttempt attemptOf(const Recording& recording) {
    RecordedAttempt attempt;
    attempt.file = recording.file;
    attempt.framed = true;
    attempt.head = recording.head;
    attempt.head.values.clear();
    for (const auto& [key, value] : recording.head.values)
        attempt.values.push_back({0, key, value, 1, 0});
    for (const RecordingNote& note : recording.changes)
        attempt.changes.push_back(changeOf(note));
    for (const RecordingNote& note : recording.events)
        (spoilsScore(note.name) ? attempt.events : attempt.notes)
            .push_back({static_cast<size_t>(note.steps), note.name, note.value});
    attempt.rows = recording.steps.size();
    const auto lit = std::find_if(recording.steps.begin(), recording.steps.end(),
                                  [](const RecordingStep& step) { return step.arc.burns(); });
    if (recording.head.arc && lit != recording.steps.end()) attempt.firstArc = lit->torch.time;
    attempt.redone = recording.redone;
    if (!recording.end) return attempt;
    attempt.ended = recording.end->reason;
    attempt.stateHash = recording.end->stateHash;
    attempt.realTime = recording.end->realTime;
    return attempt;
}

std::string placeOf(const RecordedAttempt& attempt, const RecordedChange& change) {
    if (!attempt.framed) return attempt.file.string() + ":" + std::to_string(change.line);
    std::string seconds = formatNumber(static_cast<float>(std::round(change.seconds * 100) / 100));
    return attempt.file.string() + ": frame " + std::to_string(change.line) + ", after " + seconds + " s";
}

void takeRecording(Lesson& lesson, const std::filesystem::path& file) {
    const Recording recording = readSoundRecording(file);
    repeatAttempt(lesson, attemptOf(recording));
    lesson.torchFile = file;
    lesson.torch = torchPathOf(recording);
    lesson.run.seconds = static_cast<float>(lesson.torch.duration());
}

} // namespace

std::optional<RecordedAttempt> readRecordedAttempt(const std::filesystem::path& file) {
    if (isRecording(file)) return attemptOf(readSoundRecording(file));
    return Reader(file).read();
}

std::optional<bool> sameEnd(const RecordedAttempt& attempt, size_t steps, std::uint64_t stateHash) {
    if (attempt.stateHash.empty() || steps != attempt.rows) return std::nullopt;
    return attempt.stateHash == formatHexadecimal(stateHash);
}

void repeatAttempt(Lesson& lesson, const RecordedAttempt& attempt) {
    if (attempt.head.lesson != lesson.key && attempt.framed)
        throw InputError(attempt.file, 0,
                         "is a recording of lesson '" + attempt.head.lesson + "'; expected one of '" + lesson.key +
                             "'");
    if (attempt.head.lesson != lesson.key)
        throw InputError(attempt.file, 2,
                         "is a record of lesson '" + attempt.head.lesson + "'; expected one of '" + lesson.key +
                             "', or a plain torch path, whose first line is not '" + std::string(kRecordFirstLine) +
                             "'");
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
    if (isRecording(file)) return takeRecording(lesson, file);
    lesson.torchFile = file;
    lesson.torch = TorchPath::read(file);
    if (!isTorchTable(file)) return;
    const auto attempt = readRecordedAttempt(file);
    if (!attempt) return;
    repeatAttempt(lesson, *attempt);
    lesson.run.seconds = static_cast<float>(lesson.torch.duration());
}

} // namespace meltpool
