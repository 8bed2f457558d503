// A picture to draw into without a window.
#pragma once

#include "core/base/image.hpp"
#include "core/gl/texture.hpp"
#include "core/render/view.hpp"

#include <memory>

namespace meltpool {

class PictureTarget {
  public:
    /// Makes sRGB colour and depth of `width` x `height` pixels. `samples` above 1: multisampled, at most the driver's
    /// limit. Throws RuntimeFault when the driver cannot draw into it.
    PictureTarget(int width, int height, int samples = 1);

    RenderTarget target() const;
    int width() const { return colour_.shape().width; }
    int height() const { return colour_.shape().height; }
    int samples() const { return samples_; }

    /// Returns the finished picture, top row first. Waits for the GPU.
    Image read() const;

    /// Resolves into the plain colour texture (a no-op without multisampling) and returns it.
    const gl::Texture& resolve() const;

  private:
    int samples_ = 1;
    gl::Texture colour_;
    gl::Texture depth_;
    gl::Texture sampledColour_;
    gl::Framebuffer plain_;
    gl::Framebuffer sampled_;
};

} // namespace meltpool
