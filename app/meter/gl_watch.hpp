// Listening to the calls of OpenGL: how long the frame's thread is inside the driver, and which calls make it wait.
#pragma once

#include <span>
#include <string_view>

namespace meltpool {

/// From here on every OpenGL call of the program tells the thread's WorkMeter. Of the context that is current, after
/// its functions were loaded. False where this cannot be done (outside Linux): everything then counts as own work.
bool watchGl();

/// The names of the calls that are listened to.
std::span<const std::string_view> watchedGlCalls();

} // namespace meltpool
