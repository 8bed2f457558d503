// Draws the metal's picture with fewer pixels than the window and enlarges it to the window.
#pragma once

#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"
#include "core/render/view.hpp"

#include <glm/vec2.hpp>

#include <memory>

namespace meltpool {

class ScaledPicture {
  public:
    explicit ScaledPicture(gl::ShaderLibrary& shaders);

    /// Returns the target for a picture with this share of the window's width and height: the window itself for 1.
    RenderTarget begin(glm::ivec2 window, float share);
    /// Enlarges the picture to the window and leaves the window's frame buffer bound.
    void end(GLuint window = 0) const;

  private:
    struct Buffers {
        gl::Texture colour, depth;
        gl::Framebuffer framebuffer{"scaled picture"};
    };
    const gl::Program& enlarge_;
    gl::VertexArray empty_;
    std::unique_ptr<Buffers> buffers_;
    glm::ivec2 window_{0};
    glm::ivec2 size_{0};
};

} // namespace meltpool
