#include "app/report/record_results.hpp"

#include "app/platform/program_info.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/trainer/result_file.hpp"
#include "core/weld/torch/torch_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

constexpr double kMm = 1e-3; // m

constexpr std::array kActions{ArcAction::out,      ArcAction::striking, ArcAction::burning,
                              ArcAction::shorting, ArcAction::stubbed,  ArcAction::breaking};

/// Arc of each step from a record's columns.
class ArcColumns {
  public:
    ArcColumns(const fs::path& file, const TorchRecording& recording)
        : file_(file),
          recording_(recording),
          length_(place("arc_length_mm")),
          current_(place("current_a")),
          voltage_(place("voltage_v")),
          action_(place("arc_state")),
          distance_(place("ctwd_mm")),
          extension_(place("extension_mm")) {}

    ArcState at(size_t step) const {
        ArcState arc;
        arc.length = static_cast<float>(number(step, length_) * kMm);
        arc.current = static_cast<float>(number(step, current_));
        arc.voltage = static_cast<float>(number(step, voltage_));
        arc.distance = static_cast<float>(number(step, distance_) * kMm);
        arc.extension = static_cast<float>(number(step, extension_) * kMm);
        const std::string& word = recording_.furtherCells[step][action_];
        const auto action =
            std::find_if(kActions.begin(), kActions.end(), [&](ArcAction each) { return arcActionName(each) == word; });
        if (action == kActions.end())
            throw InputError(file_, 0, "has an arc_state " + quote(word) + "; expected a word such as burning or out");
        arc.action = *action;
        return arc;
    }

  private:
    size_t place(std::string_view name) const {
        const auto& columns = recording_.furtherColumns;
        const auto found = std::find(columns.begin(), columns.end(), name);
        if (found == columns.end())
            throw InputError(file_, 0,
                             "has no column " + std::string(name) +
                                 "; expected the record of an attempt at a weld lesson");
        return static_cast<size_t>(found - columns.begin());
    }

    double number(size_t step, size_t column) const {
        const std::string& cell = recording_.furtherCells[step][column];
        const auto value = parseDouble(cell);
        if (!value || std::isnan(*value))
            throw InputError(file_, 0,
                             "has " + quote(cell) + " under " + recording_.furtherColumns[column] + " in step " +
                                 std::to_string(step + 1) + "; expected a number");
        return *value;
    }

    const fs::path& file_;
    const TorchRecording& recording_;
    size_t length_, current_, voltage_, action_, distance_, extension_;
};

/// Events that spoil a score, before the steps at which they happened.
class Events {
  public:
    explicit Events(const std::vector<RecordedEvent>& events) : events_(events) {}

    void happen(size_t steps, Technique& technique) {
        for (; next_ < events_.size() && events_[next_].steps <= steps; ++next_) {
            if (events_[next_].name == "torch") tracked_ = events_[next_].value != "lost";
            if (events_[next_].name == "samples") technique.noteDropped(droppedSeconds(events_[next_].value));
        }
    }
    bool tracked() const { return tracked_; }

  private:
    const std::vector<RecordedEvent>& events_;
    size_t next_ = 0;
    bool tracked_ = true;
};

/// Step of an attempt: the hand and the arc.
struct HandStep {
    TorchSample torch;
    ArcState arc;
};

std::vector<HandStep> stepsInRecording(const fs::path& file) {
    const Recording recording = readSoundRecording(file);
    if (!recording.head.arc)
        throw InputError(file, 0, "has no arc; expected the recording of an attempt at a weld lesson");
    std::vector<HandStep> steps;
    steps.reserve(recording.steps.size());
    for (const RecordingStep& step : recording.steps)
        steps.push_back({step.torch, step.arc});
    return steps;
}

std::vector<HandStep> stepsIn(const fs::path& record) {
    if (isRecording(record)) return stepsInRecording(record);
    const TorchRecording recording = readTorchCsv(record);
    const ArcColumns arcs(record, recording);
    std::vector<HandStep> steps;
    steps.reserve(recording.samples.size());
    for (size_t step = 0; step < recording.samples.size(); ++step)
        steps.push_back({recording.samples[step], arcs.at(step)});
    return steps;
}

Judgement judged(const Lesson& lesson, const std::vector<HandStep>& steps) {
    Technique technique = techniqueOf(lesson.workpiece, lesson.process, lesson.technique);
    Events events(lesson.recorded->events);
    ArcAccount account;
    double before = 0;
    for (size_t step = 0; step < steps.size(); ++step) {
        events.happen(step, technique);
        technique.add(steps[step].torch, steps[step].arc, events.tracked());
        account.add(steps[step].arc, steps[step].torch.time - before);
        before = steps[step].torch.time;
    }
    Judgement judgement =
        judgeAttempt(technique, {}, {lesson.technique, lesson.acceptance, lesson.nominalWeld(), lesson.process});
    judgement.arc = account;
    judgement.realTime = lesson.recorded->realTime.value_or(1);
    return judgement;
}

} // namespace

RunResults readRecordResults(const fs::path& record, const Lesson& lesson) {
    Lesson repeated = lesson;
    takeTorch(repeated, record);
    if (!repeated.recorded)
        throw InputError(record, 1, "is no record of an attempt; expected a first line '# meltpool record 1'");
    ResultContext context;
    context.version = programVersion();
    context.commit = programCommit();
    context.renderer = repeated.recorded->head.driver;
    context.attempt = factsOf(*repeated.recorded);
    context.judgement = judged(repeated, stepsIn(record));
    RunResults results = resultsOf(resultEntries(repeated, nullptr, context), context.judgement);
    results.notes.push_back(
        phrase("page.note.record_alone", {{"lesson", repeated.key}, {"record", record.filename().string()}}));
    if (repeated.recorded->ended.empty()) results.notes.push_back(phrase("page.note.cut_short"));
    return results;
}

} // namespace meltpool
