// Binds Dear ImGui to the window: frames, fonts that follow the screen's scale, and the input that Dear ImGui takes for
// itself.
#pragma once

#include "app/desktop/steering.hpp"
#include "app/desktop/window.hpp"
#include "app/session/gamepad_keys.hpp"
#include "app/ui/widgets.hpp"

#include <chrono>

namespace meltpool::ui {

class Interface {
  public:
    /// Call this after the window has installed its own callbacks.
    explicit Interface(Window& window);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// Adds the keys that the gamepad's buttons mean now to `input`, and lets hints name what is in use. Call before
    /// begin().
    void takeGamepad(InputFrame& input, GamepadUse use, double seconds);
    /// Begins a frame. `size`: the person's factor on the desktop's scale. `captured`: the interface ignores the mouse.
    /// `byKeyboard`: keys and the gamepad's buttons move between the controls; `input`: of this frame.
    void begin(float size, bool captured, bool byKeyboard, const InputFrame& input);
    /// Shows the keyboard's focus in the next frame, see Steering::show().
    void showFocus(ImGuiDir idle) { steering_.show(idle); }
    /// Removes the interface's own input from `input`. Call between begin() and end().
    void takeInput(InputFrame& input, bool captured) const;
    /// Draws the frame into the window's frame buffer.
    void end();
    /// Ends a frame without drawing it.
    void drop();

    Context& context() { return context_; }

  private:
    using Clock = std::chrono::steady_clock;

    void rebuildFonts(float scale, float pixelScale);

    Window& window_;
    Context context_;
    float pixelScale_ = 0;
    GamepadKeys gamepadKeys_;
    Steering steering_;
    Clock::time_point lastBegin_ = Clock::now();
};

} // namespace meltpool::ui
