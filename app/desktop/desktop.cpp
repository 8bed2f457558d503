#include "app/desktop/desktop.hpp"

#include "app/desktop/desktop_app.hpp"

#include <csignal>

namespace meltpool {

namespace {

volatile std::sig_atomic_t stopAsked = 0;

extern "C" void askToStop(int) {
    stopAsked = 1;
}

/// While it lives SIGINT and SIGTERM close the window as its close button does.
class StopSignals {
  public:
    StopSignals() : interrupt_(std::signal(SIGINT, askToStop)), terminate_(std::signal(SIGTERM, askToStop)) {
        stopAsked = 0;
    }
    ~StopSignals() {
        std::signal(SIGINT, interrupt_);
        std::signal(SIGTERM, terminate_);
    }
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

  private:
    void (*interrupt_)(int);
    void (*terminate_)(int);
};

} // namespace

int runDesktop(const DesktopOptions& options) {
    const StopSignals signals;
    DesktopApp app(options);
    while (!app.closing() && stopAsked == 0)
        app.frame();
    return app.finish() ? 0 : 1;
}

} // namespace meltpool
