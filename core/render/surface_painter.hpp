// Draws the metal's surface: filled in a material or in temperature colours, or as a wireframe.
#pragma once

#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"
#include "core/render/look.hpp"
#include "core/render/material_presets.hpp"
#include "core/render/scene.hpp"
#include "core/render/toned_program.hpp"
#include "core/render/view.hpp"

#include <optional>

namespace meltpool {

class SurfacePainter {
  public:
    explicit SurfacePainter(gl::ShaderLibrary& shaders);

    /// Draws with the frame's uniforms as they are. Translucent materials first draw their far side into a picture of
    /// the viewport's size.
    void draw(const SceneView& scene, const LookParameters& look, int firstView, const RenderTarget& target,
              const Viewport& viewport);
    void drawWireframe(const SurfaceMesh& mesh, int firstView, const RenderTarget& target) const;

  private:
    struct FarSide {
        gl::Texture side;
        gl::Texture depth;
        gl::Framebuffer framebuffer{"far side"};
    };

    void drawFarSide(const SurfaceMesh& mesh, int firstView, const RenderTarget& target, const Viewport& viewport);
    void drawMesh(const SurfaceMesh& mesh, const gl::Program& program, int firstView) const;

    TonedProgram metal_;
    TonedProgram hotMetal_;
    TonedProgram wax_;
    TonedProgram ice_;
    TonedProgram temperature_;
    TonedProgram wire_;
    const gl::Program& back_;
    gl::VertexArray layout_;
    gl::VertexArray empty_;
    std::optional<FarSide> farSide_;
};

} // namespace meltpool
