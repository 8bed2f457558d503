// Shows a flat picture in space (a quad layer). The runtime draws it, so its text is sharper than text drawn into the
// eyes.
#pragma once

#include "core/gl/texture.hpp"
#include "xr/pose.hpp"

#include <glm/vec2.hpp>

#include <optional>

namespace meltpool::xr {

struct PanelShape {
    int widthPixels = 900;
    int heightPixels = 1100;
    float width = 0.6f; ///< m; the height follows from the pixels
};

/// The point where a ray along the pose's -Z meets a panel of this size (m) that faces along its own +Z: pixels from
/// the top left corner, or empty if it misses or comes from behind.
std::optional<glm::vec2> pointOnPanel(const Pose& ray, const Pose& panel, const PanelShape& shape);

class Panel {
  public:
    Panel(GLenum format, const PanelShape& shape);

    const PanelShape& shape() const { return shape_; }
    /// The frame buffer to draw into, top row at the top.
    GLuint framebuffer() const { return framebuffer_.name(); }
    GLuint texture() const { return colour_.name(); }

  private:
    PanelShape shape_;
    gl::Texture colour_;
    gl::Framebuffer framebuffer_;
};

} // namespace meltpool::xr
