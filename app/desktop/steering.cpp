#include "app/desktop/steering.hpp"

#include <algorithm>

namespace meltpool::ui {

namespace {

#if IMGUI_VERSION_NUM < 18900
constexpr bool kEnterChooses = false; // only Space chooses a button there
#else
constexpr bool kEnterChooses = true;
#endif

#if IMGUI_VERSION_NUM < 18700
constexpr bool kLosesTaps = true; // keys pressed and released between two frames
#else
constexpr bool kLosesTaps = false;
#endif

/// Arrow keys, in the order of ImGuiDir.
struct Arrow {
    Key key;
    GamepadButton button;
};
constexpr std::array<Arrow, 4> kArrows{{{Key::left, GamepadButton::left},
                                        {Key::right, GamepadButton::right},
                                        {Key::up, GamepadButton::up},
                                        {Key::down, GamepadButton::down}}};

void setKey(ImGuiKey key, bool down) {
    ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM < 18700
    if (const int index = io.KeyMap[key]; index >= 0) io.KeysDown[index] = down;
#else
    io.AddKeyEvent(key, down);
#endif
}

bool tapped(const InputFrame& input, Key key) {
    return kLosesTaps && input.isHeld(key);
}

/// The gamepad repeats by itself: its buttons are pressed for a frame each time.
bool pressedArrow(const InputFrame& input, const Arrow& arrow) {
    if (!input.gamepad.isHeld(arrow.button)) return tapped(input, arrow.key);
    return std::find(input.pressed.begin(), input.pressed.end(), arrow.key) != input.pressed.end();
}

} // namespace

/// Returns true while a press of A, or of Enter where Dear ImGui does not take it, chooses a control.
bool Steering::chooses(bool steers, const InputFrame& input) {
    const bool enter = input.gamepad.isHeld(GamepadButton::a) || (!kEnterChooses && input.isHeld(Key::enter));
    if (enter && !enterBefore_) chooses_ = steers && !ImGui::GetIO().WantTextInput;
    chooses_ = chooses_ && enter && steers;
    enterBefore_ = enter;
    return chooses_;
}

void Steering::press(bool steers, const InputFrame& input) {
    constexpr std::array<ImGuiKey, 7> kKeys{ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_UpArrow,
                                            ImGuiKey_DownArrow, ImGuiKey_Space,      ImGuiKey_Escape,
                                            ImGuiKey_Enter};
    const bool choose = chooses(steers, input);
    std::array<bool, 7> wanted{};
    if (steers) {
        for (size_t way = 0; way < kArrows.size(); ++way)
            wanted[way] = pressedArrow(input, kArrows[way]) || idle_ == static_cast<ImGuiDir>(way);
        idle_ = ImGuiDir_None;
        wanted[4] = choose || tapped(input, Key::space);
        wanted[5] = input.gamepad.isHeld(GamepadButton::b) || tapped(input, Key::escape);
        wanted[6] = tapped(input, Key::enter) && !input.gamepad.isHeld(GamepadButton::a);
    }
    for (size_t i = 0; i < kKeys.size(); ++i)
        if (wanted[i] != pressed_[i]) setKey(kKeys[i], wanted[i]);
    pressed_ = wanted;
}

} // namespace meltpool::ui
