// `meltpool replay`: a recorded attempt welded again, unchanged or with one thing changed.
#include "app/activities/file_checkpoints.hpp"
#include "app/commands/attempt_files.hpp"
#include "app/commands/attempt_welder.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/comparison_output.hpp"
#include "app/commands/named_lesson.hpp"
#include "app/platform/say.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/training/judging/cures.hpp"
#include "core/training/lesson/changed_path.hpp"
#include "core/training/lesson/lesson.hpp"

#include <cmath>
#include <cstdio>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

/// Shortens the lesson to one time with its picture.
void seek(Lesson& lesson, const std::string& second) {
    const auto at = parseDouble(second);
    const double end = lesson.torch.duration();
    if (!at || !(*at >= 0) || !(*at <= end))
        throw InputError("--seek is " + quote(second) + "; expected a second of the attempt, from 0 to " +
                         formatNumber(static_cast<float>(end)));
    lesson.run.seconds = static_cast<float>(*at);
    lesson.run.picturesEvery = 0;
}

Lesson requestedAttempt(const ReplayRequest& request) {
    Lesson lesson = openAttempt(request.file, request.lesson);
    setPictures(lesson, request.size, request.picturesEvery);
    setView(lesson, request.views);
    if (request.seek.empty()) return lesson;
    if (!request.whatIf.empty()) throw InputError("--seek and --what-if exclude each other; expected one of them");
    seek(lesson, request.seek);
    return lesson;
}

/// Hooks with the warnings, which the result holds as that of `run` does.
RunHooks warned(const std::vector<std::string>& warnings) {
    RunHooks hooks;
    hooks.warnings = warnings;
    hooks.warn = warn;
    return hooks;
}

/// Makes the run begin at the newest of `moments` that is not beyond its end.
void beginAt(RecordedCheckpoints& moments, RunHooks& hooks) {
    hooks.start = [&moments](Trainer& trainer) {
        const auto moment = moments.beforeStep(stepsOfRun(trainer));
        if (!moment) return;
        trainer.restore(*moment);
        say("%s\n", phrase("run.replay.begins", {{"seconds", PhraseNumber(trainer.time(), 2)}}).c_str());
    };
}

/// Welds to the lesson's end, which is the requested second.
void weldSought(AttemptWelder& welder, const Lesson& lesson, RunFolder& folder, RunHooks hooks) {
    const FileCheckpoints recorded = fileCheckpoints(lesson, welder.machine());
    if (!recorded.refused.empty()) say("%s\n", printable(recorded.refused, 1000).c_str());
    if (recorded.moments) beginAt(*recorded.moments, hooks);
    welder.weld(lesson, folder, hooks);
}

/// Mean travel speed, m/s, over the judged millimetres of a run's seam; nothing if none is known.
std::optional<double> meanTravelSpeed(const RunResults& run) {
    const std::vector<double> speeds = run.technique.column("speed_mm_s"), judged = run.technique.column("judged");
    double sum = 0;
    int count = 0;
    for (size_t i = 0; i < std::min(speeds.size(), judged.size()); ++i)
        if (judged[i] > 0 && std::isfinite(speeds[i])) {
            sum += speeds[i];
            ++count;
        }
    return count > 0 ? std::optional(sum / count * 1e-3) : std::nullopt;
}

/// Welds the attempt unchanged and stores each step of the hand.
std::vector<AttemptStep> weldOriginal(AttemptWelder& welder, const Lesson& lesson, RunFolder& folder, RunHooks hooks) {
    std::vector<AttemptStep> steps;
    steps.reserve(lesson.recorded->rows);
    hooks.torch = [&steps](const Trainer& trainer) {
        const TorchSample torch = trainer.demonstration();
        steps.push_back({torch, static_cast<double>(trainer.metal().model().burntOff()), trainer.arc().burns()});
        return torch;
    };
    welder.weld(lesson, folder, hooks);
    return steps;
}

void weldChanged(AttemptWelder& welder, Lesson lesson, const std::vector<AttemptStep>& steps, const WhatIf& whatIf,
                 RunFolder& folder, RunHooks hooks) {
    hooks.whatIf = whatIf.asked;
    takeWhatIf(lesson, whatIf, whatIf.path.speed);
    if (lesson.model != LessonModel::Weld) { // its torch follows no seam
        welder.weld(lesson, folder, hooks);
        return;
    }
    const ChangedPath path(steps, seamOf(lesson.workpiece), whatIf.path);
    lesson.run.seconds = static_cast<float>(path.duration());
    hooks.torch = [&path](const Trainer& trainer) {
        return path.sample(trainer.time() + trainer.timeStep(),
                           static_cast<double>(trainer.metal().model().burntOff()));
    };
    welder.weld(lesson, folder, hooks);
}

/// Keys of the imperfections that fail in a run; nothing for a run without a verdict.
std::optional<std::vector<std::string>> failedIn(const RunResults& run) {
    const auto verdict = run.result.find("verdict");
    if (verdict == run.result.end() || !verdict->is_object() || !verdict->contains("items")) return std::nullopt;
    std::vector<std::string> keys;
    for (const auto& item : verdict->at("items"))
        if (item.value("state", "") == nameOf(VerdictState::fail)) keys.push_back(item.value("name", ""));
    return keys;
}

/// Prints the imperfections that pass only with the change, and those that fail in spite of it or only with it.
void tellOutcome(const WhatIf& whatIf, const RunResults& original, const RunResults& changed) {
    const auto failed = failedIn(original), failedThen = failedIn(changed);
    if (failed && failedThen) say("%s\n", whatIfOutcome(whatIf.text(), *failed, *failedThen).c_str());
}

void replayChanged(const ReplayRequest& request, const Lesson& lesson) {
    WhatIf whatIf = readWhatIf(request.whatIf, lesson);
    RunFolder original(request.folder / "original", lessonSources(lesson));
    RunFolder changed(request.folder / "what-if", lessonSources(lesson));
    const RunHooks hooks = warned(tellWarnings(lesson));
    AttemptWelder welder;
    const std::vector<AttemptStep> steps = weldOriginal(welder, lesson, original, hooks);
    const ComparedRun first{phrase("run.replay.original"), readRunResults(original.path())};
    whatIf.path = whatIf.path.resolved(meanTravelSpeed(first.results));
    weldChanged(welder, lesson, steps, whatIf, changed, hooks);
    const ComparedRun second{phrase("run.replay.what_if", {{"changes", whatIf.text()}}),
                             readRunResults(changed.path())};
    tellOutcome(whatIf, first.results, second.results);
    tellComparison(first, second, request.folder, request.page);
}

} // namespace

void replayAttempt(const ReplayRequest& request) {
    const Lesson lesson = requestedAttempt(request);
    if (!request.whatIf.empty()) {
        replayChanged(request, lesson);
        return;
    }
    RunFolder folder(request.folder, lessonSources(lesson));
    const RunHooks hooks = warned(tellWarnings(lesson));
    AttemptWelder welder;
    if (request.seek.empty())
        welder.weld(lesson, folder, hooks);
    else
        weldSought(welder, lesson, folder, hooks);
    sayResult({}, folder.result());
}

} // namespace meltpool
