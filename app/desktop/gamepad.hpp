// A gamepad, read through GLFW.
#pragma once

#include "app/session/input.hpp"

#include <span>

namespace meltpool {

/// What GLFW says of a gamepad, as the trainer takes it. `axes`: GLFW_GAMEPAD_AXIS_* in their order, -1..1 (sticks: x
/// to the right, y towards the person; triggers: -1 is released). `buttons`: GLFW_GAMEPAD_BUTTON_* in their order, 1
/// pressed. A stick or trigger that hardly leaves its rest counts as at rest, as no stick rests at 0.
GamepadFrame gamepadFrame(std::span<const float, 6> axes, std::span<const unsigned char, 15> buttons);

/// The first gamepad that GLFW knows a mapping for, as it is now; at rest where there is none. Needs a started window
/// system, see startWindowSystem().
GamepadFrame readGamepad();

} // namespace meltpool
