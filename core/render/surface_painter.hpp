// Painter of the metal's surface: filled in a material or in temperature colours, or as a wireframe.
#pragma once

#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"
#include "core/render/floating_oxide.hpp"
#include "core/render/look/look.hpp"
#include "core/render/look/material_presets.hpp"
#include "core/render/measured_program.hpp"
#include "core/render/scene.hpp"
#include "core/render/toned_program.hpp"
#include "core/render/view.hpp"

#include <optional>

namespace meltpool {

class SurfacePainter {
  public:
    explicit SurfacePainter(gl::ShaderLibrary& shaders);

    /// Loads the programs' forms for one way of submission. Throws InputError when the driver does not compile one.
    void load(ViewSubmission submission);

    /// Prepares a frame whose batches have `instances` views; call it before the first draw.
    void prepare(const SceneView& scene, const LookParameters& look, int instances);

    /// Draws the surface. Expects the frame's uniform blocks bound. `count`: number of all views of the target.
    /// Translucent materials first draw their far side into a texture of the target's size.
    void draw(const SceneView& scene, const LookParameters& look, const ViewBatch& views, int count,
              const RenderTarget& target);
    void drawWireframe(const SurfaceMesh& mesh, const ViewBatch& views, const RenderTarget& target) const;

  private:
    struct FarSide {
        FarSide() : framebuffer("far side") {}
        gl::Texture side;
        gl::Texture depth;
        gl::Framebuffer framebuffer;
    };

    void bindFreezing(const SurfaceMesh& mesh) const;
    void addVertexAttribute(GLuint attribute, GLint components, size_t offset);
    void drawFarSide(const SurfaceMesh& mesh, const ViewBatch& views, int count, const RenderTarget& target);
    void fitFarSide(int width, int height);
    void drawHotMetal(const SurfaceMesh& mesh, const LookParameters& look, const ViewBatch& views,
                      const RenderTarget& target) const;
    void drawMesh(const SurfaceMesh& mesh, const ViewBatch& views) const;
    const gl::Buffer& commandFor(const SurfaceMesh& mesh, const ViewBatch& views) const;

    TonedProgram metal_;
    /// All of the metal, then the pool's mirror image over it.
    MeasuredProgram hotMetal_, pool_;
    bool rippled_ = false; ///< true if they show ripples
    TonedProgram wax_;
    TonedProgram ice_;
    TonedProgram temperature_;
    TonedProgram wire_;
    ViewProgram back_;
    FloatingOxide oxide_;
    gl::VertexArray layout_;
    gl::VertexArray empty_;
    std::optional<FarSide> farSide_;
    /// The mesh's draw command with an instance a view, and the instance counts that the GPU copies into it.
    gl::Buffer command_;
    gl::Buffer counts_;
};

} // namespace meltpool
