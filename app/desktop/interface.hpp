// Binds Dear ImGui to the window: frames, fonts that follow the screen's scale, and the input that Dear ImGui takes for
// itself.
#pragma once

#include "app/desktop/window.hpp"
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

    /// Begins a frame. `size`: the person's factor on the desktop's scale. `captured`: the interface ignores the mouse.
    /// `byKeyboard`: keys move between the controls.
    void begin(float size, bool captured, bool byKeyboard);
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
    Clock::time_point lastBegin_ = Clock::now();
};

} // namespace meltpool::ui
