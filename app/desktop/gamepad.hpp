// Reads a gamepad through GLFW.
#pragma once

#include "app/session/input.hpp"

#include <span>

namespace meltpool {

/// Converts GLFW's gamepad values to the trainer's. `axes`: GLFW_GAMEPAD_AXIS_* in their order, -1..1 (sticks: x to the
/// right, y towards the person; triggers: -1 is released). `buttons`: GLFW_GAMEPAD_BUTTON_* in their order, 1 pressed.
/// A stick or trigger close to its rest counts as at rest, since no stick rests at 0.
GamepadFrame gamepadFrame(std::span<const float, 6> axes, std::span<const unsigned char, 15> buttons);

/// Reads the first gamepad for which GLFW knows a mapping; returns one at rest if there is none. Needs a started window
/// system, see startWindowSystem().
GamepadFrame readGamepad();

} // namespace meltpool
