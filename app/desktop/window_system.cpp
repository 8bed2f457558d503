#include "app/desktop/window_system.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#ifdef __linux__
#include <X11/Xlib.h>

/// GLFW/glfw3native.h declares it too, but needs headers of other extensions.
extern "C" Display* glfwGetX11Display(void);
#endif

#include <atomic>
#include <cstdlib>

namespace meltpool {

namespace {

std::atomic<bool> lost{false};

#ifdef GLFW_PLATFORM_X11 // exists since GLFW 3.4
bool isSet(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}
#endif

} // namespace

bool startWindowSystem() {
#ifdef GLFW_PLATFORM_X11
    // libwayland finds no compositor without these two variables and writes so to standard error.
    const bool mayHaveWayland = isSet("XDG_RUNTIME_DIR") || isSet("WAYLAND_SOCKET");
    if ((isSet("DISPLAY") || !mayHaveWayland) && glfwPlatformSupported(GLFW_PLATFORM_X11) == GLFW_TRUE) {
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
        if (glfwInit() == GLFW_TRUE) return true;
        if (!mayHaveWayland) return false;
        glfwInitHint(GLFW_PLATFORM, GLFW_ANY_PLATFORM);
    }
#endif
    return glfwInit() == GLFW_TRUE;
}

void surviveLostDisplay() {
    lost = false;
#ifdef __linux__
    Display* display = glfwGetX11Display();
    if (display == nullptr) return;
    // Xlib's own handlers end the process, the first with a line of its own.
    XSetIOErrorHandler([](Display*) {
        lost = true;
        return 0;
    });
    XSetIOErrorExitHandler(
        display, [](Display*, void*) {}, nullptr);
#endif
}

bool displayLost() {
    return lost;
}

} // namespace meltpool
