// Opens a window with an OpenGL 4.5 context and reads keyboard, mouse and gamepad.
#pragma once

#include "app/desktop/window_place.hpp"
#include "app/session/input.hpp"
#include "app/session/key_names.hpp"
#include "core/gl/context.hpp"

#include <glm/vec2.hpp>

#include <memory>
#include <string>

struct GLFWwindow;

namespace meltpool {

class Window {
  public:
    struct Options {
        int width = 1280; ///< screen points
        int height = 720;
        int samples = 4; ///< per pixel; 0 if the processor draws
    };

    /// Opens the window, hidden until show(). Throws InputError in one sentence if there is no display or the driver
    /// has less than OpenGL 4.5 core.
    explicit Window(const Options& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Sets the window's size; call before show(). `size`: of the window's inside at an ordinary density; it grows with
    /// the desktop's scale and is fitted into the work area of the screen with the mouse pointer.
    void resize(glm::ivec2 size, bool maximised);
    /// Makes swap() wait for the display, or not. It waits at first; it must not wait while the headset paces the
    /// frames.
    void waitForDisplay(bool wait);
    void show();
    void swap();
    /// Reads the events since the last call; waits up to `patience` seconds for one.
    InputFrame poll(double patience);
    /// Returns true if the window had events in one of the last polls.
    bool stirred() const { return quietPolls_ < kSettlingPolls; }

    bool closing() const;
    void close();
    void captureMouse(bool captured);
    /// Switches to full screen, on the screen that shows most of the window, and back.
    void toggleFullScreen();
    void setTitle(const std::string& title);

    // Values of the last poll(): a call to the display each time would take longer than most of a frame's work.
    glm::ivec2 size() const { return size_; }     ///< screen points
    glm::ivec2 pixels() const { return pixels_; } ///< pixels of the frame buffer
    bool minimised() const;
    bool maximised() const;
    bool fullScreen() const { return fullScreen_; }
    /// Size of the window to save for the next start, at an ordinary density: the last one that was neither maximised
    /// nor full screen. It is the size given to resize() until the person changes it.
    glm::ivec2 normalSize() const;
    /// Factor of the desktop on the interface's sizes in screen points (HiDPI if points are pixels).
    float interfaceScale() const;
    /// Pixels a screen point.
    float pixelScale() const;

    /// Names of the keyboard's layout, read when the last key was pressed or the window got the focus.
    const KeyNames& keyNames() const { return keyNames_; }
    const gl::ContextInfo& driver() const { return driver_; }
    GLFWwindow* handle() const { return window_; }

  private:
    void open(const Options& options);
    void await(double patience);
    void stir() { quietPolls_ = 0; }
    void onKey(int key, int action, int modifiers);
    void readKeyNames();
    void onButton(int button, bool down);
    void onFocus(bool focused);
    void onScroll(double way);
    void onMove(glm::dvec2 position);
    void onSize(glm::ivec2 size);
    void onPixels(glm::ivec2 pixels);

    /// A click consists of press and release and may then change the pointer's shape, so the interface needs some more
    /// polls.
    static constexpr int kSettlingPolls = 4;

    GLFWwindow* window_ = nullptr;
    int quietPolls_ = 0; ///< polls since the last event
    gl::ContextInfo driver_;
    InputFrame gathering_;
    GamepadFrame gamepad_; ///< at the last poll
    KeyNames keyNames_;
    std::bitset<static_cast<size_t>(Key::count)> down_;
    bool leftDown_ = false;
    bool rightDown_ = false;
    glm::dvec2 mouse_{0};
    bool mouseKnown_ = false;
    bool captured_ = false;
    bool focused_ = false;
    bool waits_ = true;
    bool fullScreen_ = false;
    bool iconified_ = false;
    glm::ivec2 size_{0};
    glm::ivec2 pixels_{0};
    glm::ivec2 normalSize_{1280, 720};
    glm::ivec2 wantedSize_{1280, 720}; ///< points at an ordinary density
    glm::ivec2 fittedSize_{0};         ///< size that resize() made of wantedSize_
    glm::ivec2 normalPlace_{0};
};

} // namespace meltpool
