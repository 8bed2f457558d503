#include "app/commands/commands.hpp"

#include "app/headset/headset_front_end.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "xr/instance.hpp"

#include <cstdio>

namespace meltpool {

namespace {

/// Throws for requests that need a window or a headset: they must not be ignored silently.
void refuseWithoutDisplay(const DesktopOptions& options, const std::string& missing) {
    const char* option = nullptr;
    if (options.headset == HeadsetUse::wanted) option = "--headset";
    if (!options.telemetry.empty()) option = "--telemetry";
    if (!options.replay.empty()) option = "--replay";
    if (options.person) option = "--person";
    if (options.watchShaders) option = "--watch-shaders";
    if (option != nullptr)
        throw InputError("there is no display (" + missing + "), and " + option +
                         " needs the trainer's window; expected a desktop session, or no " + option);
}

} // namespace

bool runTrainer(const DesktopOptions& options) {
    const std::string missing = missingDisplay();
    if (missing.empty()) {
        // Before the desktop's sound has a thread: that reads the environment, which a new variable moves.
        xr::quietLoader();
        DesktopOptions complete = options;
        complete.makeHeadset = [](const std::filesystem::path& folder) {
            return std::make_unique<HeadsetFrontEnd>(folder);
        };
        return runDesktop(complete) == 0;
    }
    refuseWithoutDisplay(options, missing);
    RunRequest demonstration;
    demonstration.lesson = options.lesson.empty() ? std::string(kDefaultLesson) : options.lesson;
    demonstration.folder = std::filesystem::path("out") / std::filesystem::path(demonstration.lesson).stem();
    demonstration.record = options.record;
    demonstration.ghost = options.ghost;
    std::printf("There is no display (%s); the demonstration of lesson '%s' runs without one instead.\n",
                missing.c_str(), printable(demonstration.lesson, 200).c_str());
    std::fflush(stdout);
    runLesson(demonstration);
    return true;
}

} // namespace meltpool
