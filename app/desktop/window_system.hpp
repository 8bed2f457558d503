// Starts GLFW in the same way for every command.
#pragma once

namespace meltpool {

/// glfwInit() with X where there is an X display, XWayland included: headsets are bound through GLX, and GLFW's own
/// choice tries Wayland first, whose library writes to the terminal where none runs. False where no window can be
/// opened; glfwGetError() then says why.
bool startWindowSystem();

} // namespace meltpool
