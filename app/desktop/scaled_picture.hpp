// The metal's picture with fewer pixels than the window has, enlarged to the window.
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

    /// Where to draw a picture with this share of the window's width and height: the window itself for 1.
    RenderTarget begin(glm::ivec2 window, float share);
    /// Enlarges what was drawn to the window, whose frame buffer is left bound.
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
