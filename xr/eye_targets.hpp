// Holds the frame buffer of both eyes: one wide multisampled picture, the left eye on the left, resolved before it is
// copied to the runtime's swapchains.
#pragma once

#include "core/gl/texture.hpp"

namespace meltpool::xr {

/// Both eyes are next to each other, so that one submission can fill them through two viewports.
class EyeTargets {
  public:
    /// `width` x `height` pixels an eye. `samples` is lowered to the driver's limit. `colour` is a sized 8-bit format,
    /// `depth` a sized depth format. Throws RuntimeFault if the driver cannot draw into them.
    EyeTargets(GLenum colour, GLenum depth, int width, int height, int samples);

    int width() const { return width_; } ///< width of one eye
    int height() const { return height_; }
    int samples() const { return samples_; }
    /// True if the driver encodes written colours while GL_FRAMEBUFFER_SRGB is on.
    bool encodesSrgb() const { return colour_.shape().format != GL_RGBA8; }

    /// Frame buffer of both eyes, 2 * width() wide, colour and depth.
    GLuint framebuffer() const { return drawn_.name(); }

    /// Averages the samples into the finished picture, and takes the depth of one sample a pixel.
    void resolve() const;
    /// The resolved picture of both eyes, for the window's mirror and tests.
    GLuint resolved() const { return finished_.name(); }

    /// The resolved picture as textures, 2 * width() wide.
    GLuint finishedColour() const { return finishedColour_.name(); }
    GLuint finishedDepth() const { return finishedDepth_.name(); }

  private:
    int width_;
    int height_;
    int samples_;
    gl::Texture colour_;
    gl::Texture depth_;
    gl::Texture finishedColour_;
    gl::Texture finishedDepth_;
    gl::Framebuffer drawn_;
    gl::Framebuffer finished_;
};

} // namespace meltpool::xr
