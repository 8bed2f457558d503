#include "app/desktop/window_system.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>

namespace meltpool {

bool startWindowSystem() {
#ifdef GLFW_PLATFORM_X11 // since GLFW 3.4
    const char* display = std::getenv("DISPLAY");
    if (display != nullptr && *display != '\0' && glfwPlatformSupported(GLFW_PLATFORM_X11) == GLFW_TRUE) {
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
        if (glfwInit() == GLFW_TRUE) return true;
        glfwInitHint(GLFW_PLATFORM, GLFW_ANY_PLATFORM);
    }
#endif
    return glfwInit() == GLFW_TRUE;
}

} // namespace meltpool
