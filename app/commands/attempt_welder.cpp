#include "app/commands/attempt_welder.hpp"

#include "app/platform/program_info.hpp"
#include "app/platform/say.hpp"
#include "app/platform/stop_signals.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/training/lesson/lesson_capacity.hpp"
#include "core/training/trainer/repetition.hpp"

#include <chrono>
#include <cstdio>

namespace meltpool {

namespace {

/// Time after which a weld that was asked to stop, but is in the middle of a long step, is ended.
constexpr std::chrono::seconds kPatience(2);
constexpr size_t kLongestShown = 1000;

} // namespace

AttemptWelder::AttemptWelder() : shaders_(resourceFolder() / "shaders") {}

ReplayMachine AttemptWelder::machine() const {
    return {programBuild(), context_.info().renderer};
}

LessonResult AttemptWelder::weld(const Lesson& lesson, RunFolder& folder, const RunHooks& hooks) {
    StopSignals signals;
    signals.endAfter(kPatience, {});
    requireCapacity(lesson, machineCapacity());
    if (const size_t removed = folder.clear(); removed > 0) say("%s\n", removedText(folder.path(), removed).c_str());
    RunStop stop;
    stop.asked = StopSignals::asked;
    stop.grant = [&signals] { signals.grantStop(); };
    stop.endAfter = [&signals](const std::function<void()>& last) { signals.endAfter(kPatience, last); };
    const LessonResult result = runHeadless(context_.info(), shaders_, lesson,
                                            {folder.result(), folder.telemetry(), folder.path()}, stop, hooks);
    say("%s\n", phrase("run.welded", {{"lesson", printable(lesson.key, kLongestShown)},
                                      {"seconds", PhraseNumber(result.seconds, 2)},
                                      {"steps", std::to_string(result.steps)},
                                      {"folder", printable(folder.path().string(), kLongestShown)}})
                    .c_str());
    if (lesson.recorded && hooks.whatIf.empty())
        say("%s\n", repetitionText(*lesson.recorded, result, programBuild(), context_.info().renderer).c_str());
    std::fflush(stdout);
    return result;
}

} // namespace meltpool
