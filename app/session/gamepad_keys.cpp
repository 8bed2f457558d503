#include "app/session/gamepad_keys.hpp"

namespace meltpool {

namespace {

struct ButtonKey {
    GamepadUse use;
    GamepadButton button;
    Key key;
};

constexpr ButtonKey kButtonKeys[] = {
    {GamepadUse::menus, GamepadButton::a, Key::enter},
    {GamepadUse::menus, GamepadButton::b, Key::escape},
    {GamepadUse::menus, GamepadButton::y, Key::tab},
    {GamepadUse::menus, GamepadButton::view, Key::h},
    {GamepadUse::menus, GamepadButton::up, Key::up},
    {GamepadUse::menus, GamepadButton::down, Key::down},
    {GamepadUse::menus, GamepadButton::left, Key::left},
    {GamepadUse::menus, GamepadButton::right, Key::right},

    {GamepadUse::torch, GamepadButton::a, Key::enter},
    {GamepadUse::torch, GamepadButton::b, Key::backspace},
    {GamepadUse::torch, GamepadButton::x, Key::j},
    {GamepadUse::torch, GamepadButton::y, Key::tab},
    {GamepadUse::torch, GamepadButton::view, Key::h},
    {GamepadUse::torch, GamepadButton::menu, Key::v},
    {GamepadUse::torch, GamepadButton::rightThumb, Key::g},
    {GamepadUse::torch, GamepadButton::up, Key::w},
    {GamepadUse::torch, GamepadButton::down, Key::s},
    {GamepadUse::torch, GamepadButton::left, Key::a},
    {GamepadUse::torch, GamepadButton::right, Key::d},

    {GamepadUse::playing, GamepadButton::a, Key::space},
    {GamepadUse::playing, GamepadButton::x, Key::f5},
    {GamepadUse::playing, GamepadButton::y, Key::tab},
    {GamepadUse::playing, GamepadButton::view, Key::h},
    {GamepadUse::playing, GamepadButton::menu, Key::v},
    {GamepadUse::playing, GamepadButton::left, Key::left},
    {GamepadUse::playing, GamepadButton::right, Key::right},
    {GamepadUse::playing, GamepadButton::up, Key::w},
    {GamepadUse::playing, GamepadButton::down, Key::s},

    {GamepadUse::cut, GamepadButton::b, Key::x},
    {GamepadUse::cut, GamepadButton::x, Key::j},
    {GamepadUse::cut, GamepadButton::y, Key::tab},
    {GamepadUse::cut, GamepadButton::view, Key::h},
    {GamepadUse::cut, GamepadButton::left, Key::left},
    {GamepadUse::cut, GamepadButton::right, Key::right},
};

bool isOfPad(GamepadButton button) {
    return button >= GamepadButton::up && button < GamepadButton::count;
}

/// True if a stick, a trigger or a button is out of its rest.
bool isUsed(const GamepadFrame& gamepad) {
    GamepadFrame rest;
    rest.connected = gamepad.connected;
    return gamepad != rest;
}

} // namespace

std::optional<Key> keyOf(GamepadButton button, GamepadUse use) {
    for (const ButtonKey& entry : kButtonKeys)
        if (entry.use == use && entry.button == button) return entry.key;
    return std::nullopt;
}

void GamepadKeys::translate(InputFrame& input, GamepadUse use, double seconds) {
    if (!input.struck.empty() || input.leftHeld || input.rightHeld || input.scroll != 0)
        lastUsed_ = false;
    else if (isUsed(input.gamepad))
        lastUsed_ = true;
    untilRepeat_ -= seconds;
    bool repeats = false;
    for (size_t i = 0; i < before_.size(); ++i) {
        const auto button = static_cast<GamepadButton>(i);
        if (!input.gamepad.isHeld(button)) continue;
        const std::optional<Key> key = keyOf(button, use);
        if (!key) continue;
        input.held[static_cast<size_t>(*key)] = true;
        if (!before_[i]) {
            input.pressed.push_back(*key);
            input.struck.push_back(*key);
            untilRepeat_ = kFirstRepeat;
        } else if (isOfPad(button) && untilRepeat_ <= 0) {
            input.pressed.push_back(*key);
            repeats = true;
        }
    }
    if (repeats) untilRepeat_ = kRepeat;
    before_ = input.gamepad.buttons;
}

} // namespace meltpool
