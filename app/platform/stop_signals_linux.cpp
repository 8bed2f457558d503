#include "app/platform/stop_signals.hpp"

#include <csignal>
#include <cstring>

#include <unistd.h>

namespace meltpool {

namespace {

extern "C" void askToStop(int signal) {
    StopSignals::wish(signal == SIGINT);
}

} // namespace

void StopSignals::say(const char* sentence) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, sentence, std::strlen(sentence));
}

void StopSignals::catchSignals() {
    interrupt_ = std::signal(SIGINT, askToStop);
    terminate_ = std::signal(SIGTERM, askToStop);
    hangUp_ = std::signal(SIGHUP, askToStop);
    if (hangUp_ == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

void StopSignals::leaveSignals() {
    std::signal(SIGINT, interrupt_);
    std::signal(SIGTERM, terminate_);
    std::signal(SIGHUP, hangUp_);
}

} // namespace meltpool
