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
    f10,
    f11,
    f12,
    count
};

/// Gamepad input; all at rest without a gamepad. Sticks -1..1, to the right and away from the person positive.
struct GamepadFrame {
    glm::vec2 left{0};
    glm::vec2 right{0};
    float leftTrigger = 0; ///< 0 released .. 1 pulled through
    float rightTrigger = 0;
    bool leftShoulder = false;
    bool rightShoulder = false;
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
    GamepadFrame gamepad;

    bool isHeld(Key key) const { return held[static_cast<size_t>(key)]; }
};

} // namespace meltpool
