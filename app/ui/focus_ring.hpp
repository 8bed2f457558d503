// The windows of the menus between which a key moves the keyboard's focus.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace meltpool::ui {

/// Windows in the order in which they are drawn. Names must outlive the ring.
class FocusRing {
  public:
    void beginFrame() { last_ = std::exchange(now_, {}); }
    /// Notes a window of this frame; `focused`: it has the keyboard's focus.
    void note(const char* window, bool focused) {
        if (now_.count == now_.windows.size()) return;
        if (focused) now_.focused = now_.count;
        now_.windows[now_.count++] = window;
    }
    /// Window of the last frame after the focused one, the first one after the last; null without any.
    const char* following() const {
        if (last_.count == 0) return nullptr;
        return last_.windows[(last_.focused + 1) % last_.count];
    }

  private:
    struct Frame {
        std::array<const char*, 8> windows{};
        size_t count = 0;
        size_t focused = 0;
    };
    Frame now_, last_;
};

} // namespace meltpool::ui
