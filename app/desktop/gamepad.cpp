#include "app/desktop/gamepad.hpp"

#include "core/base/environment.hpp"
#include "core/base/text.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

namespace meltpool {

namespace {

constexpr float kStickRest = 0.15F;
constexpr float kTriggerRest = 0.05F;

/// Beyond its dead zone a stick begins at 0, so that slow movements are possible.
glm::vec2 stick(float x, float y) {
    const glm::vec2 pushed(x, -y);
    const float way = std::min(glm::length(pushed), 1.0F);
    if (way <= kStickRest) return {0, 0};
    return glm::normalize(pushed) * ((way - kStickRest) / (1 - kStickRest));
}

float trigger(float axis) {
    const float pulled = std::clamp((axis + 1) / 2, 0.0F, 1.0F);
    return pulled <= kTriggerRest ? 0 : (pulled - kTriggerRest) / (1 - kTriggerRest);
}

constexpr std::array<std::pair<int, GamepadButton>, static_cast<size_t>(GamepadButton::count)> kButtons{{
    {GLFW_GAMEPAD_BUTTON_A, GamepadButton::a},
    {GLFW_GAMEPAD_BUTTON_B, GamepadButton::b},
    {GLFW_GAMEPAD_BUTTON_X, GamepadButton::x},
    {GLFW_GAMEPAD_BUTTON_Y, GamepadButton::y},
    {GLFW_GAMEPAD_BUTTON_BACK, GamepadButton::view},
    {GLFW_GAMEPAD_BUTTON_START, GamepadButton::menu},
    {GLFW_GAMEPAD_BUTTON_RIGHT_THUMB, GamepadButton::rightThumb},
    {GLFW_GAMEPAD_BUTTON_DPAD_UP, GamepadButton::up},
    {GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, GamepadButton::right},
    {GLFW_GAMEPAD_BUTTON_DPAD_DOWN, GamepadButton::down},
    {GLFW_GAMEPAD_BUTTON_DPAD_LEFT, GamepadButton::left},
}};

/// Text of the file; empty if it cannot be read.
std::string textOf(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

const std::array<std::string_view, 15> kGamepadButtonNames{
    "a",     "b",          "x",           "y",  "left_shoulder", "right_shoulder", "view", "menu",
    "guide", "left_thumb", "right_thumb", "up", "right",         "down",           "left",
};

GamepadFrame gamepadFrame(std::span<const float, 6> axes, std::span<const unsigned char, 15> buttons) {
    GamepadFrame frame;
    frame.connected = true;
    for (const auto& [known, button] : kButtons)
        frame.buttons[static_cast<size_t>(button)] = buttons[static_cast<size_t>(known)] == GLFW_PRESS;
    frame.left = stick(axes[GLFW_GAMEPAD_AXIS_LEFT_X], axes[GLFW_GAMEPAD_AXIS_LEFT_Y]);
    frame.right = stick(axes[GLFW_GAMEPAD_AXIS_RIGHT_X], axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]);
    frame.leftTrigger = trigger(axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER]);
    frame.rightTrigger = trigger(axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER]);
    frame.leftShoulder = buttons[GLFW_GAMEPAD_BUTTON_LEFT_BUMPER] == GLFW_PRESS;
    frame.rightShoulder = buttons[GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER] == GLFW_PRESS;
    return frame;
}

GamepadFrame gamepadFromText(std::string_view text) {
    std::array<float, 6> axes{0, 0, 0, 0, -1, -1};
    std::array<unsigned char, 15> buttons{};
    size_t axis = 0;
    for (const std::string_view word : splitText(trimText(text), ' ')) {
        const auto name = std::find(kGamepadButtonNames.begin(), kGamepadButtonNames.end(), word);
        if (name != kGamepadButtonNames.end())
            buttons[static_cast<size_t>(name - kGamepadButtonNames.begin())] = GLFW_PRESS;
        else if (const auto value = parseDouble(word); value && axis < axes.size())
            axes[axis++] = static_cast<float>(std::clamp(*value, -1.0, 1.0));
    }
    return gamepadFrame(axes, buttons);
}

GamepadFrame readGamepad() {
    static const std::string script = environmentVariable("MELTPOOL_GAMEPAD");
    if (!script.empty()) return gamepadFromText(textOf(script));
    for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
        GLFWgamepadstate state;
        if (glfwJoystickIsGamepad(joystick) == GLFW_FALSE || glfwGetGamepadState(joystick, &state) == GLFW_FALSE)
            continue;
        return gamepadFrame(state.axes, state.buttons);
    }
    return {};
}

} // namespace meltpool
