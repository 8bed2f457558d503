#include "app/desktop/desktop.hpp"

#include "app/desktop/desktop_app.hpp"
#include "app/desktop/window_system.hpp"
#include "app/platform/stop_signals.hpp"
#include "core/gl/software_driver/software_driver.hpp"

#include <cstdio>
#include <cstdlib>

namespace meltpool {

int runDesktop(const DesktopOptions& options) {
    const StopSignals signals;
    // Steps and picture have a thread each, so the driver needs none of its own. The wide pictures of a headset need
    // them.
    if (options.headset != HeadsetUse::wanted) gl::runDriverSingleThreaded();
    DesktopApp app(options);
    surviveLostDisplay();
    while (!app.closing() && !StopSignals::asked() && !displayLost())
        app.frame();
    const int code = app.finish() ? 0 : 1;
    if (displayLost()) {
        std::fputs("meltpool: the display is gone, so the window closes\n", stderr);
        std::fflush(nullptr);
        std::_Exit(1); // closing the window would ask the display
    }
    return code;
}

} // namespace meltpool
