// Views and targets: all that the renderer knows of windows, files and eyes.
#pragma once

#include "core/gl/gl.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace meltpool {

/// One eye or camera. Eye space is right-handed and looks along -Z; clip depth is OpenGL's -1..1.
struct View {
    glm::mat4 worldToEye{1.0f};
    glm::mat4 eyeToClip{1.0f};
    glm::vec3 eye{0.0f}; ///< place of the eye in world units
};

/// Pixels, from the lower left corner of the frame buffer.
struct Viewport {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// Returns a column of a viewport that is divided into `columns` equal ones, counted from the left.
Viewport columnOf(const Viewport& whole, int column, int columns);

/// Parts of both eyes' pictures that the lenses do not show: corners of triangles in the plane z = -1 of each eye.
struct HiddenArea {
    std::array<std::span<const glm::vec2>, 2> corners; ///< three a triangle
    std::uint64_t version = 0;                         ///< another one for other corners; 0: none
};

/// A frame buffer with colour and depth. Several views are side by side in equal columns of the viewport, from the
/// left.
struct RenderTarget {
    GLuint framebuffer = 0; ///< 0: the window's
    Viewport viewport;
    /// True: the colour attachment is an sRGB format, which encodes written values. False (a window): the shaders
    /// encode.
    bool encodesSrgb = false;
    const HiddenArea* hidden = nullptr; ///< parts of two views that are not drawn; may be null
};

/// A symmetric perspective projection.
struct Lens {
    float fieldOfView = 0.7854f; ///< angle of the picture's height, rad
    float nearest = 0.02f;       ///< closest distance drawn, world units
    float farthest = 100.0f;     ///< farthest distance drawn, world units
};

/// Returns the view of an eye at `position` looking along `orientation` * -Z. `aspect` is width over height.
View makeView(const glm::vec3& position, const glm::quat& orientation, const Lens& lens, float aspect);

} // namespace meltpool
