#include "app/desktop/window.hpp"

#include "app/desktop/desktop.hpp"
#include "app/desktop/gamepad.hpp"
#include "app/desktop/window_place.hpp"
#include "app/desktop/window_system.hpp"

#include "core/base/environment.hpp"
#include "core/base/error.hpp"
#include "core/base/work_meter.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace meltpool {

namespace {

constexpr std::array<std::pair<int, Key>, static_cast<size_t>(Key::count) + 1> kKeys{{
    {GLFW_KEY_A, Key::a},
    {GLFW_KEY_C, Key::c},
    {GLFW_KEY_D, Key::d},
    {GLFW_KEY_E, Key::e},
    {GLFW_KEY_F, Key::f},
    {GLFW_KEY_G, Key::g},
    {GLFW_KEY_H, Key::h},
    {GLFW_KEY_J, Key::j},
    {GLFW_KEY_K, Key::k},
    {GLFW_KEY_N, Key::n},
    {GLFW_KEY_Q, Key::q},
    {GLFW_KEY_R, Key::r},
    {GLFW_KEY_S, Key::s},
    {GLFW_KEY_V, Key::v},
    {GLFW_KEY_W, Key::w},
    {GLFW_KEY_X, Key::x},
    {GLFW_KEY_LEFT, Key::left},
    {GLFW_KEY_RIGHT, Key::right},
    {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, Key::down},
    {GLFW_KEY_PAGE_UP, Key::pageUp},
    {GLFW_KEY_PAGE_DOWN, Key::pageDown},
    {GLFW_KEY_ESCAPE, Key::escape},
    {GLFW_KEY_ENTER, Key::enter},
    {GLFW_KEY_BACKSPACE, Key::backspace},
    {GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_TAB, Key::tab},
    {GLFW_KEY_LEFT_SHIFT, Key::shift},
    {GLFW_KEY_RIGHT_SHIFT, Key::shift},
    {GLFW_KEY_F1, Key::f1},
    {GLFW_KEY_F2, Key::f2},
    {GLFW_KEY_F3, Key::f3},
    {GLFW_KEY_F4, Key::f4},
    {GLFW_KEY_F5, Key::f5},
    {GLFW_KEY_F6, Key::f6},
    {GLFW_KEY_F9, Key::f9},
    {GLFW_KEY_F10, Key::f10},
    {GLFW_KEY_F11, Key::f11},
    {GLFW_KEY_F12, Key::f12},
}};

std::string lastProblem() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "no reason given" : text;
}

/// Returns the driver's OpenGL version if the program asks for none in particular.
std::string offeredVersion() {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* probe = glfwCreateWindow(64, 64, "Meltpool", nullptr, nullptr);
    if (probe == nullptr) return "no OpenGL at all (" + lastProblem() + ")";
    glfwMakeContextCurrent(probe);
    using GetString = const unsigned char* (*)(unsigned);
    const auto getString = reinterpret_cast<GetString>(glfwGetProcAddress("glGetString"));
    const auto text = [&](unsigned name) {
        const unsigned char* value = getString == nullptr ? nullptr : getString(name);
        return value == nullptr ? std::string("unknown") : std::string(reinterpret_cast<const char*>(value));
    };
    std::string found = "OpenGL " + text(GL_VERSION) + " on " + text(GL_RENDERER);
    glfwDestroyWindow(probe);
    return found;
}

/// Advice on how a machine with too old a graphics card still shows the window; empty if it changes nothing.
std::string softwareAdvice() {
#ifdef __linux__
    if (environmentVariable("LIBGL_ALWAYS_SOFTWARE").empty())
        return "; to draw on the processor, set LIBGL_ALWAYS_SOFTWARE=1 in the environment, or choose \"Without the "
               "graphics card\" in the program's desktop menu";
#endif
    return {};
}

void start() {
    if (!startWindowSystem()) throw InputError("the window cannot open: " + lastProblem());
}

/// Sets the hints for the next window, which is hidden at first.
void hintContext(int samples) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, gl::debugBuild() ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_SAMPLES, samples);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE); // Windows: the window grows when it comes to a denser screen
}

std::span<GLFWmonitor* const> monitors() {
    int count = 0;
    GLFWmonitor** all = glfwGetMonitors(&count);
    return {all, static_cast<size_t>(count)};
}

/// Returns the whole area of a monitor; without a size if it is switched off.
ScreenArea monitorArea(GLFWmonitor* monitor) {
    ScreenArea area;
    glfwGetMonitorPos(monitor, &area.corner.x, &area.corner.y);
    if (const GLFWvidmode* mode = glfwGetVideoMode(monitor)) area.size = {mode->width, mode->height};
    return area;
}

/// Returns the monitor that shows most of the area; null if there is none.
GLFWmonitor* monitorOf(const ScreenArea& area) {
    std::vector<ScreenArea> screens;
    for (GLFWmonitor* monitor : monitors())
        screens.push_back(monitorArea(monitor));
    return screens.empty() ? nullptr : monitors()[screenOf(area, screens)];
}

/// Returns the monitor's work area; without a size if there is no monitor.
ScreenArea workAreaOf(GLFWmonitor* monitor) {
    ScreenArea area;
    if (monitor != nullptr) glfwGetMonitorWorkarea(monitor, &area.corner.x, &area.corner.y, &area.size.x, &area.size.y);
    return area;
}

Window& self(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

} // namespace

std::string missingDisplay() {
    if (!startWindowSystem()) return lastProblem();
    glfwTerminate();
    return {};
}

Window::Window(const Options& options) : normalSize_(options.width, options.height) {
    start();
    try {
        open(options);
        driver_ = gl::useCurrentContext(gl::debugBuild());
        if (driver_.software && options.samples > 0) {
            // Four samples a pixel take too long if the processor draws.
            glfwDestroyWindow(std::exchange(window_, nullptr));
            Options plain = options;
            plain.samples = 0;
            open(plain);
            driver_ = gl::useCurrentContext(gl::debugBuild());
        }
    } catch (...) {
        if (window_ != nullptr) glfwDestroyWindow(window_);
        glfwTerminate();
        throw;
    }
}

void Window::open(const Options& options) {
    hintContext(options.samples);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "meltpool");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "meltpool");
    window_ = glfwCreateWindow(options.width, options.height, "Meltpool", nullptr, nullptr);
    if (window_ == nullptr)
        throw InputError("the window needs OpenGL 4.5 core, but this computer offers " + offeredVersion() +
                         softwareAdvice());
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);

    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(
        window_, [](GLFWwindow* w, int key, int, int action, int modifiers) { self(w).onKey(key, action, modifiers); });
    glfwSetMouseButtonCallback(
        window_, [](GLFWwindow* w, int button, int action, int) { self(w).onButton(button, action == GLFW_PRESS); });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { self(w).onMove({x, y}); });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double y) { self(w).onScroll(y); });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { self(w).stir(); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int on) { self(w).onFocus(on == GLFW_TRUE); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { self(w).stir(); });
    glfwSetWindowSizeCallback(window_, [](GLFWwindow* w, int x, int y) { self(w).onSize({x, y}); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int x, int y) { self(w).onPixels({x, y}); });
    glfwSetWindowIconifyCallback(window_, [](GLFWwindow* w, int on) { self(w).iconified_ = on == GLFW_TRUE; });
    glfwGetWindowSize(window_, &size_.x, &size_.y);
    glfwGetFramebufferSize(window_, &pixels_.x, &pixels_.y);
    iconified_ = false;
    readKeyNames();
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::resize(glm::ivec2 size, bool maximised) {
    ScreenArea inside;
    glfwGetWindowPos(window_, &inside.corner.x, &inside.corner.y);
    glm::dvec2 pointer{0};
    glfwGetCursorPos(window_, &pointer.x, &pointer.y);
    const ScreenArea workArea = workAreaOf(monitorOf({inside.corner + glm::ivec2(pointer), {1, 1}}));
    WindowFrame frame;
    glfwGetWindowFrameSize(window_, &frame.topLeft.x, &frame.topLeft.y, &frame.bottomRight.x, &frame.bottomRight.y);

    const float scale = interfaceScale();
    wantedSize_ = size;
    normalSize_ = fittedSize_ = inside.size = fittingSize(size, scale, workArea, frame);
    const glm::ivec2 least = leastSize(scale, fittedSize_);
    glfwSetWindowSizeLimits(window_, least.x, least.y, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowSize(window_, inside.size.x, inside.size.y);
    if (const auto place = placeInside(inside, frame, workArea)) glfwSetWindowPos(window_, place->x, place->y);
    if (maximised) glfwMaximizeWindow(window_);
}

void Window::show() {
    glfwShowWindow(window_);
    glfwFocusWindow(window_);
}

void Window::waitForDisplay(bool wait) {
    if (wait == waits_) return;
    waits_ = wait;
    glfwSwapInterval(wait ? 1 : 0);
}

void Window::swap() {
    const InWork driver(WorkPlace::driver);
    glfwSwapBuffers(window_);
}

/// Waits up to `patience` seconds for an event. A gamepad sends none, so its state is looked at often.
void Window::await(double patience) {
    constexpr double kLook = 0.02; // s
    for (bool first = true; first || patience > 0; first = false) {
        const double part = gamepad_.connected ? std::min(patience, kLook) : patience;
        if (part > 0)
            glfwWaitEventsTimeout(part);
        else
            glfwPollEvents();
        patience -= std::max(part, 0.0);
        // Another program may use the same gamepad.
        const GamepadFrame now = focused_ ? readGamepad() : GamepadFrame{};
        GamepadFrame resting;
        resting.connected = now.connected;
        if (now != std::exchange(gamepad_, now) || now != resting) stir();
        if (quietPolls_ == 0) return;
    }
}

InputFrame Window::poll(double patience) {
    if (stirred()) ++quietPolls_;
    await(patience);
    // A key or button pressed and released between two frames counts as held in one frame.
    gathering_.held |= down_;
    gathering_.leftHeld |= leftDown_;
    gathering_.rightHeld |= rightDown_;
    gathering_.gamepad = gamepad_;
    return std::exchange(gathering_, InputFrame{});
}

void Window::readKeyNames() {
    keyNames_.read([](Key key) {
        const auto* known = std::find_if(kKeys.begin(), kKeys.end(), [key](const auto& k) { return k.second == key; });
        const char* name = known == kKeys.end() ? nullptr : glfwGetKeyName(known->first, 0);
        return name == nullptr ? std::string() : std::string(name);
    });
}

void Window::onKey(int key, int action, int modifiers) {
    stir();
    readKeyNames(); // the layout may have changed with this key
    const auto* known = std::find_if(kKeys.begin(), kKeys.end(), [key](const auto& k) { return k.first == key; });
    if (known == kKeys.end()) return;
    const auto bit = static_cast<size_t>(known->second);
    // A key with Ctrl, Alt or the system's key is a command to another program.
    const bool alone = (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) == 0;
    down_[bit] = action == GLFW_PRESS ? alone : action == GLFW_REPEAT && down_[bit];
    if (!down_[bit]) return;
    gathering_.held[bit] = true;
    gathering_.pressed.push_back(known->second);
    if (action == GLFW_PRESS) gathering_.struck.push_back(known->second);
}

void Window::onButton(int button, bool down) {
    stir();
    if (button == GLFW_MOUSE_BUTTON_LEFT) {
        leftDown_ = down;
        gathering_.leftHeld |= down;
    } else if (button == GLFW_MOUSE_BUTTON_RIGHT) {
        rightDown_ = down;
        gathering_.rightHeld |= down;
    }
}

void Window::onFocus(bool focused) {
    stir();
    focused_ = focused;
    gathering_.lostFocus |= !focused;
    readKeyNames();
}

void Window::onScroll(double way) {
    stir();
    gathering_.scroll += static_cast<float>(way);
}

void Window::onMove(glm::dvec2 position) {
    stir();
    const glm::vec2 way = mouseKnown_ ? glm::vec2(position - mouse_) : glm::vec2(0);
    gathering_.mouseMove += way;
    if (leftDown_ || rightDown_) gathering_.dragMove += way;
    mouse_ = position;
    mouseKnown_ = true;
}

void Window::onSize(glm::ivec2 size) {
    stir();
    size_ = size;
    if (!fullScreen_ && !maximised() && size.x > 0 && size.y > 0) normalSize_ = size;
}

void Window::onPixels(glm::ivec2 pixels) {
    stir();
    pixels_ = pixels;
}

bool Window::closing() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::captureMouse(bool captured) {
    if (captured == captured_) return;
    captured_ = captured;
    glfwSetInputMode(window_, GLFW_CURSOR, captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    glfwGetCursorPos(window_, &mouse_.x,
                     &mouse_.y); // the position jumps at the change without any movement of the mouse
}

void Window::toggleFullScreen() {
    fullScreen_ = !fullScreen_;
    if (!fullScreen_) {
        glfwSetWindowMonitor(window_, nullptr, normalPlace_.x, normalPlace_.y, normalSize_.x, normalSize_.y, 0);
        return;
    }
    glfwGetWindowPos(window_, &normalPlace_.x, &normalPlace_.y);
    GLFWmonitor* monitor = monitorOf({normalPlace_, size_});
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) {
        fullScreen_ = false;
        return;
    }
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    glfwSwapInterval(1);
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

glm::ivec2 Window::normalSize() const {
    if (normalSize_ == fittedSize_) return wantedSize_;
    const glm::vec2 size = glm::vec2(normalSize_) / interfaceScale();
    return {static_cast<int>(std::lround(size.x)), static_cast<int>(std::lround(size.y))};
}

bool Window::minimised() const {
    return iconified_ || pixels_.x == 0 || pixels_.y == 0;
}

bool Window::maximised() const {
    return glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
}

float Window::pixelScale() const {
    const int width = size().x;
    return width > 0 ? static_cast<float>(pixels().x) / static_cast<float>(width) : 1.0f;
}

float Window::interfaceScale() const {
    glm::vec2 content{1};
    glfwGetWindowContentScale(window_, &content.x, &content.y);
    // The system scales already if a point is larger than a pixel (macOS, Wayland).
    return std::clamp(content.x / std::max(pixelScale(), 1e-3f), 0.5f, 4.0f);
}

} // namespace meltpool
