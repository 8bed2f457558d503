// Implements window, screenshot and frames for the headset's tests.
#include "tests/xr/monado_run.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/gl/context.hpp"

#include <GLFW/glfw3.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace meltpool::test {

namespace {

std::string fromBench(const char* variable) {
    const char* value = std::getenv(variable);
    if (value == nullptr) throw RuntimeFault("this test runs under tests/xr/run_on_monado.sh only");
    return value;
}

/// Returns the 8 bits of a colour mask.
std::uint8_t channel(unsigned long pixel, unsigned long mask) {
    while (mask != 0 && (mask & 1u) == 0) {
        mask >>= 1;
        pixel >>= 1;
    }
    return static_cast<std::uint8_t>(pixel & mask & 0xffu);
}

constexpr const char* kLayer = "XR_APILAYER_LUNARG_core_validation";

/// Sets the variable before main, since the loader reads it when the first instance is made.
const bool layerAsked = [] {
    const char* folder = std::getenv("MELTPOOL_XR_BENCH");
    if (folder == nullptr) return false;
    setenv("XR_ENABLE_API_LAYERS", kLayer, 1);
    setenv("XR_CORE_VALIDATION_EXPORT_TYPE", "text", 1);
    setenv("XR_CORE_VALIDATION_FILE_NAME", (std::filesystem::path(folder) / "validation.txt").c_str(), 1);
    return true;
}();

} // namespace

std::string misuses() {
    const std::filesystem::path file = runFolder() / "validation.txt";
    if (!layerAsked || !std::filesystem::exists(file)) throw RuntimeFault("the OpenXR validation layer did not run");
    static size_t answered = 0; // bytes of the file that earlier calls have read
    const std::string text = readTextFile(file);
    std::string found;
    for (const std::string_view line : splitText(std::string_view(text).substr(answered), '\n'))
        if (line.find("VALID_ERROR") != line.npos || line.find("VALID_WARNING") != line.npos)
            found += std::string(line) + "\n";
    answered = text.size();
    return found;
}

std::filesystem::path runFolder() {
    return fromBench("MELTPOOL_XR_BENCH");
}

int driverPort() {
    return std::atoi(fromBench("MELTPOOL_XR_PORT").c_str());
}

int servicePid() {
    return std::atoi(readTextFile(runFolder() / "service.pid").c_str());
}

GLFWwindow* hiddenWindow() {
    static GLFWwindow* window = [] {
        if (glfwInit() == GLFW_FALSE) throw RuntimeFault("no X display for the test's window");
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        GLFWwindow* made = glfwCreateWindow(320, 240, "headset test", nullptr, nullptr);
        if (made == nullptr) throw RuntimeFault("no OpenGL 4.5 window for the test");
        glfwMakeContextCurrent(made);
        glfwSwapInterval(0);
        gl::useCurrentContext(true);
        return made;
    }();
    glfwMakeContextCurrent(window);
    return window;
}

Image screenshot() {
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) throw RuntimeFault("no X display for the screenshot");
    const int screen = DefaultScreen(display);
    const int width = DisplayWidth(display, screen), height = DisplayHeight(display, screen);
    XImage* shot =
        XGetImage(display, RootWindow(display, screen), 0, 0, unsigned(width), unsigned(height), AllPlanes, ZPixmap);
    Image image{width, height, {}};
    image.rgb.reserve(size_t(width) * size_t(height) * 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const unsigned long pixel = XGetPixel(shot, x, y);
            for (const unsigned long mask : {shot->red_mask, shot->green_mask, shot->blue_mask})
                image.rgb.push_back(channel(pixel, mask));
        }
    XDestroyImage(shot);
    XCloseDisplay(display);
    return image;
}

Image shownEye(const Image& screen, int eye) {
    // Size of Monado's window for its remote headset.
    constexpr int kWidth = 480, kHeight = 540;
    Image cut{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y) {
        const auto row = screen.rgb.begin() + (std::ptrdiff_t(y) * screen.width + std::ptrdiff_t(eye) * kWidth) * 3;
        cut.rgb.insert(cut.rgb.end(), row, row + kWidth * 3);
    }
    return cut;
}

void keepPicture(const Image& image, const std::string& name) {
    if (const char* folder = std::getenv("MELTPOOL_XR_PICTURES")) writePng(std::filesystem::path(folder) / name, image);
}

xr::FrameTiming stepFrame(xr::Headset& headset, const std::function<void(const xr::BothEyes&)>& draw,
                          const std::function<void()>& beforeEnd) {
    try {
        headset.poll();
        if (headset.running()) {
            const xr::FrameTiming timing = headset.waitFrame();
            headset.beginFrame();
            if (timing.shouldRender && draw) headset.drawEyes(draw);
            if (beforeEnd) beforeEnd();
            headset.endFrame();
            return timing;
        }
    } catch (const xr::Stalled&) {
        // The machine is busy; poll() continues when the runtime has answered.
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return {};
}

namespace {

/// Repeats `turn` until it returns true; false after kPatience.
template <class Turn>
bool repeatUntil(const Turn& turn) {
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + std::chrono::duration<double>(kPatience); Clock::now() < end;)
        if (turn()) return true;
    return false;
}

} // namespace

bool waitUntil(const std::function<bool()>& done) {
    return repeatUntil([&] {
        if (done()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        return false;
    });
}

bool stepFrames(xr::Headset& headset, int count, const std::function<void(const xr::BothEyes&)>& draw,
                const std::function<void()>& beforeEnd) {
    int whole = 0;
    return repeatUntil([&] {
        if (whole < count && stepFrame(headset, draw, beforeEnd).displayTime != 0) ++whole;
        return whole >= count;
    });
}

bool stepUntil(xr::Headset& headset, const std::function<bool()>& done,
               const std::function<void(const xr::BothEyes&)>& draw) {
    return repeatUntil([&] {
        if (done()) return true;
        stepFrame(headset, draw);
        return false;
    });
}

bool waitUntilOpen(xr::Headset& headset) {
    return waitUntil([&] { return headset.opened(); });
}

bool reach(xr::Headset& headset, xr::SessionMode mode) {
    return waitUntilOpen(headset) && stepUntil(headset, [&] { return headset.mode() == mode; });
}

} // namespace meltpool::test
