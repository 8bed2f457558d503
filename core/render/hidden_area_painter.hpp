// Spares the drawing of those corners of a headset's picture that its lenses do not show.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"
#include "core/render/view.hpp"

#include <cstdint>
#include <span>

namespace meltpool {

class HiddenAreaPainter {
  public:
    explicit HiddenAreaPainter(gl::ShaderLibrary& shaders);

    /// Sets the depth of the target's hidden area to the nearest, after the clear; later things are not drawn there.
    /// Leaves the depth test on, with GL_LESS.
    void draw(std::span<const View> views, const RenderTarget& target);
    /// Paints the hidden area black, after everything else: the desk's window shows it. Leaves the depth test off.
    void blacken(std::span<const View> views, const RenderTarget& target);

  private:
    void upload(const HiddenArea& area);
    void drawTriangles(std::span<const View> views, const RenderTarget& target);

    const gl::Program& program_;
    gl::VertexArray layout_{"hidden area"};
    gl::Buffer corners_;
    std::uint64_t version_ = 0; ///< version of the uploaded area
};

} // namespace meltpool
