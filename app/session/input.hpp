// Input of keyboard, mouse and gamepad since the last frame, independent of the window library.
#pragma once

#include <glm/vec2.hpp>

#include <bitset>
#include <vector>

namespace meltpool {

/// Keys that the trainer uses.
enum class Key {
    a,
    c,
    d,
    e,
    f,
    g,
    h,
    j,
    k,
    n,
    q,
    r,
    s,
    v,
    w,
    x,
    left,
    right,
    up,
    down,
    pageUp,
    pageDown,
    escape,
    enter,
    backspace,
    space,
    tab,
    shift,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f9,
    f10,
    f11,
    f12,
    count
};

/// Buttons of a gamepad. Of the four at the right a is the lower, b the right, x the left, y the upper one, whatever is
/// printed on them; rightThumb is the right stick, pressed in. The last four are those of the directional pad.
enum class GamepadButton { a, b, x, y, view, menu, rightThumb, up, right, down, left, count };

/// Gamepad input; all at rest without a gamepad. Sticks -1..1, to the right and away from the person positive.
struct GamepadFrame {
    bool connected = false;
    std::bitset<static_cast<size_t>(GamepadButton::count)> buttons; ///< held
    glm::vec2 left{0};
    glm::vec2 right{0};
    float leftTrigger = 0; ///< 0 released .. 1 pulled through
    float rightTrigger = 0;
    bool leftShoulder = false;
    bool rightShoulder = false;

    bool isHeld(GamepadButton button) const { return buttons[static_cast<size_t>(button)]; }
    bool operator==(const GamepadFrame&) const = default;
};

struct InputFrame {
    std::bitset<static_cast<size_t>(Key::count)> held;
    std::vector<Key> pressed; ///< in order; a held key repeats at the keyboard's rate
    std::vector<Key> struck;  ///< `pressed` without the repeats
    glm::vec2 mouseMove{0};   ///< travel to the right and downwards, in screen points
    glm::vec2 dragMove{0};    ///< the part of mouseMove with a button down
    float scroll = 0;         ///< wheel notches, away from the person positive
    bool leftHeld = false;
    bool rightHeld = false;
    bool lostFocus = false; ///< another window got the keyboard
    GamepadFrame gamepad;

    bool isHeld(Key key) const { return held[static_cast<size_t>(key)]; }
};

} // namespace meltpool
