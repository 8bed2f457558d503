#include "app/desktop/gamepad.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <glm/geometric.hpp>

#include <algorithm>

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

} // namespace

GamepadFrame gamepadFrame(std::span<const float, 6> axes, std::span<const unsigned char, 15> buttons) {
    GamepadFrame frame;
    frame.left = stick(axes[GLFW_GAMEPAD_AXIS_LEFT_X], axes[GLFW_GAMEPAD_AXIS_LEFT_Y]);
    frame.right = stick(axes[GLFW_GAMEPAD_AXIS_RIGHT_X], axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]);
    frame.leftTrigger = trigger(axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER]);
    frame.rightTrigger = trigger(axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER]);
    frame.leftShoulder = buttons[GLFW_GAMEPAD_BUTTON_LEFT_BUMPER] == GLFW_PRESS;
    frame.rightShoulder = buttons[GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER] == GLFW_PRESS;
    return frame;
}

GamepadFrame readGamepad() {
    for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
        GLFWgamepadstate state;
        if (glfwJoystickIsGamepad(joystick) == GLFW_FALSE || glfwGetGamepadState(joystick, &state) == GLFW_FALSE)
            continue;
        return gamepadFrame(state.axes, state.buttons);
    }
    return {};
}

} // namespace meltpool
