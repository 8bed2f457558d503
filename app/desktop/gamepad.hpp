// Reads a gamepad through GLFW.
#pragma once

#include "app/session/input.hpp"

#include <array>
#include <span>
#include <string_view>

namespace meltpool {

/// Converts GLFW's gamepad values to the trainer's. `axes`: GLFW_GAMEPAD_AXIS_* in their order, -1..1 (sticks: x to the
/// right, y towards the person; triggers: -1 is released). `buttons`: GLFW_GAMEPAD_BUTTON_* in their order, 1 pressed.
/// A stick or trigger close to its rest counts as at rest, since no stick rests at 0.
GamepadFrame gamepadFrame(std::span<const float, 6> axes, std::span<const unsigned char, 15> buttons);

/// Reads a gamepad from a text: six axes as above, then the names of the pressed buttons, each of
/// kGamepadButtonNames. A missing axis is at rest; unknown words are left out.
GamepadFrame gamepadFromText(std::string_view text);
/// Names of GLFW_GAMEPAD_BUTTON_* in their order.
extern const std::array<std::string_view, 15> kGamepadButtonNames;

/// Reads the first gamepad for which GLFW knows a mapping; returns one at rest if there is none. Needs a started window
/// system, see startWindowSystem(). If the environment variable MELTPOOL_GAMEPAD names a file, its text is the gamepad.
GamepadFrame readGamepad();

} // namespace meltpool
