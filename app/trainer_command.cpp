#include "app/commands.hpp"

#include "core/training/lesson.hpp"

#include <cstdio>

namespace meltpool {

void runTrainer() {
    RunRequest demonstration;
    demonstration.lesson = kDefaultLesson;
    demonstration.folder = std::filesystem::path("out") / kDefaultLesson;
    std::printf("There is no display; the demonstration of lesson '%s' runs without one instead.\n",
                demonstration.lesson.c_str());
    std::fflush(stdout);
    runLesson(demonstration);
}

} // namespace meltpool
