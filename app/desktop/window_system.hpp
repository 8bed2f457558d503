// Starts GLFW in one way for every command.
#pragma once

namespace meltpool {

/// Calls glfwInit() with X if there is an X display, XWayland included: headsets are bound through GLX. GLFW's own
/// choice tries Wayland first, whose library writes to the terminal if none runs. Returns false if no window can open;
/// glfwGetError() then gives the reason.
bool startWindowSystem();

/// Keeps the program alive if the connection to the X display breaks: displayLost() reports it, and calls to the
/// display return nothing. Needs an open window. No-op with another window system, whose broken connection closes the
/// window.
void surviveLostDisplay();
bool displayLost();

} // namespace meltpool
