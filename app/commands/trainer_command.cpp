#include "app/commands/commands.hpp"

#include "app/headset/headset_front_end.hpp"
#include "core/training/lesson.hpp"

#include <cstdio>

namespace meltpool {

bool runTrainer(const DesktopOptions& options) {
    const std::string missing = missingDisplay();
    if (missing.empty()) {
        DesktopOptions complete = options;
        complete.makeHeadset = [](const std::filesystem::path& folder) {
            return std::make_unique<HeadsetFrontEnd>(folder);
        };
        return runDesktop(complete) == 0;
    }
    RunRequest demonstration;
    demonstration.lesson = kDefaultLesson;
    demonstration.folder = std::filesystem::path("out") / kDefaultLesson;
    std::printf("There is no display (%s); the demonstration of lesson '%s' runs without one instead.\n",
                missing.c_str(), demonstration.lesson.c_str());
    std::fflush(stdout);
    runLesson(demonstration);
    return true;
}

} // namespace meltpool
