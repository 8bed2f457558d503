// Chooses the window's size and place from the available screens.
#pragma once

#include <glm/vec2.hpp>

#include <optional>
#include <span>

namespace meltpool {

/// A rectangle in the system's screen points, y downwards.
struct ScreenArea {
    glm::ivec2 corner{0}; ///< top left corner
    glm::ivec2 size{0};
};

/// Widths of the system's frame around the window's inside, screen points.
struct WindowFrame {
    glm::ivec2 topLeft{0};
    glm::ivec2 bottomRight{0};
};

/// Size of the window's inside at a start: `wanted` at an ordinary density times the desktop's `scale`, at most as
/// large as `workArea` has room for inside the frame. A work area without a size is unknown and limits nothing.
glm::ivec2 fittingSize(glm::ivec2 wanted, float scale, const ScreenArea& workArea, const WindowFrame& frame);

/// Smallest size that the person may give the window: 640x480 times the scale, at most `fitting`.
glm::ivec2 leastSize(float scale, glm::ivec2 fitting);

/// Returns the place of the window's inside in the middle of the work area if it or its frame sticks out of the area.
/// Empty if nothing sticks out or the work area is unknown.
std::optional<glm::ivec2> placeInside(const ScreenArea& window, const WindowFrame& frame, const ScreenArea& workArea);

/// Returns the index of the screen that shows most of the window; the first if none shows any of it. Needs at least one
/// screen.
size_t screenOf(const ScreenArea& window, std::span<const ScreenArea> screens);

} // namespace meltpool
