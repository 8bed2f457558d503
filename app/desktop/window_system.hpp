// Starts GLFW, the same way wherever it is asked for.
#pragma once

namespace meltpool {

/// glfwInit(), on X where there is a display of it, Wayland's own X server included. Headsets are bound through GLX,
/// and a GLFW that is free to choose asks Wayland first, whose library writes to the terminal where none runs. False
/// where no window can be opened; glfwGetError() then says why.
bool startWindowSystem();

} // namespace meltpool
