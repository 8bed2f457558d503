// Draws the metal's surface: filled in a material or in temperature colours, or as a wireframe.
#pragma once

#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"
#include "core/render/look/look.hpp"
#include "core/render/look/material_presets.hpp"
#include "core/render/scene.hpp"
#include "core/render/toned_program.hpp"
#include "core/render/view/view.hpp"

#include <optional>

namespace meltpool {

class SurfacePainter {
  public:
    explicit SurfacePainter(gl::ShaderLibrary& shaders);

    /// Loads the programs' forms for one way of submission. Throws InputError when the driver does not compile one.
    void load(ViewSubmission submission);

    /// Before the first draw of a frame whose batches hold `instances` views.
    void prepare(const SurfaceMesh& mesh, int instances);

    /// Draws with the frame's uniforms as they are; `views` of the target are `count` in all. Translucent materials
    /// first draw their far side into a picture of the target's size.
    void draw(const SceneView& scene, const LookParameters& look, const ViewBatch& views, int count,
              const RenderTarget& target);
    void drawWireframe(const SurfaceMesh& mesh, const ViewBatch& views, const RenderTarget& target) const;

  private:
    struct FarSide {
        gl::Texture side;
        gl::Texture depth;
        gl::Framebuffer framebuffer{"far side"};
    };

    void addVertexAttribute(GLuint attribute, GLint components, size_t offset);
    void drawFarSide(const SurfaceMesh& mesh, const ViewBatch& views, int count, const RenderTarget& target);
    void fitFarSide(int width, int height);
    void drawMesh(const SurfaceMesh& mesh, const ViewBatch& views) const;
    const gl::Buffer& commandFor(const SurfaceMesh& mesh, const ViewBatch& views) const;

    TonedProgram metal_;
    TonedProgram hotMetal_;
    TonedProgram wax_;
    TonedProgram ice_;
    TonedProgram temperature_;
    TonedProgram wire_;
    ViewProgram back_;
    gl::VertexArray layout_;
    gl::VertexArray empty_;
    std::optional<FarSide> farSide_;
    /// The mesh's draw command with an instance a view, and the counts that are put into it without the CPU.
    gl::Buffer command_;
    gl::Buffer counts_;
};

} // namespace meltpool
