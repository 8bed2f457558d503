// Starts GLFW in the same way for every command.
#pragma once

namespace meltpool {

/// glfwInit() with X where there is an X display, XWayland included: headsets are bound through GLX, and GLFW's own
/// choice tries Wayland first, whose library writes to the terminal where none runs. False where no window can be
/// opened; glfwGetError() then says why.
bool startWindowSystem();

/// From now on a connection to the X display that breaks does not end the program: displayLost() tells it, and what is
/// asked of the display gives nothing. Needs an open window. Without effect where the window system is another one,
/// whose broken connection closes the window.
void surviveLostDisplay();
bool displayLost();

} // namespace meltpool
