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

/// The gamepad repeats by itself: its buttons are pressed for a frame each time.
bool repeats(const InputFrame& input, const Arrow& arrow) {
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
    constexpr std::array<ImGuiKey, kKeyCount> kKeys{ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_UpArrow,
                                                    ImGuiKey_DownArrow, ImGuiKey_Space,      ImGuiKey_Escape,
                                                    ImGuiKey_Enter,     ImGuiKey_Backspace};
    // In a field of text, which a mouse may have opened, a tap counts too.
    const bool taps = kLosesTaps && (steers || ImGui::GetIO().WantTextInput);
    const auto tapped = [&](Key key) { return taps && input.isHeld(key); };
    const bool choose = chooses(steers, input);
    const GamepadFrame pad = steers ? input.gamepad : GamepadFrame{};
    std::array<bool, kKeyCount> wanted{};
    for (size_t way = 0; way < kArrows.size(); ++way) {
        const bool byPad = pad.isHeld(kArrows[way].button);
        const bool idle = steers && idle_ == static_cast<ImGuiDir>(way);
        wanted[way] = idle || (byPad ? repeats(input, kArrows[way]) : tapped(kArrows[way].key));
    }
    if (steers) idle_ = ImGuiDir_None;
    wanted[4] = choose || tapped(Key::space);
    wanted[5] = pad.isHeld(GamepadButton::b) || tapped(Key::escape);
    wanted[6] = tapped(Key::enter) && !pad.isHeld(GamepadButton::a);
    wanted[7] = tapped(Key::backspace);
    for (size_t i = 0; i < kKeys.size(); ++i)
        if (wanted[i] != pressed_[i]) setKey(kKeys[i], wanted[i]);
    pressed_ = wanted;
}

} // namespace meltpool::ui
