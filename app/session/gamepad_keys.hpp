// The keys that a gamepad's buttons mean: a page that is worked by keys is worked by a gamepad too.
#pragma once

#include "app/session/input.hpp"

#include <optional>

namespace meltpool {

/// Activity that gives the buttons their meaning.
enum class GamepadUse {
    menus,   ///< controls are chosen: pages before a lesson, its menus, a question
    torch,   ///< the person's own torch, or the free camera
    playing, ///< a demonstration or a replay
    cut      ///< the weld is cut open
};

/// Key that the button means; nothing if it has no use there.
std::optional<Key> keyOf(GamepadButton button, GamepadUse use);

class GamepadKeys {
  public:
    static constexpr double kFirstRepeat = 0.4; ///< s until a held button of the directional pad repeats
    static constexpr double kRepeat = 0.1;      ///< s between its repeats

    /// Adds the keys that the buttons mean now to `input`, `seconds` after the last call.
    void translate(InputFrame& input, GamepadUse use, double seconds);
    /// True if the newest input came from the gamepad, and not from keys or mouse buttons.
    bool lastUsed() const { return lastUsed_; }

  private:
    decltype(GamepadFrame::buttons) before_;
    double untilRepeat_ = 0;
    bool lastUsed_ = false;
};

} // namespace meltpool
