#include "core/render/surface_painter.hpp"

#include "shaders/shared/surface.h"

#include <array>

namespace meltpool {

namespace {

constexpr GLuint kPeak = 2; // vertex attribute

} // namespace

SurfacePainter::SurfacePainter(gl::ShaderLibrary& shaders)
    : metal_(shaders, "render/metal.vert", "render/metal.frag"),
      hotMetal_(shaders, "render/hot_metal.vert", "render/hot_metal.frag"),
      wax_(shaders, "render/surface.vert", "render/wax.frag"),
      ice_(shaders, "render/surface.vert", "render/ice.frag"),
      temperature_(shaders, "render/temperature.vert", "render/temperature.frag"),
      wire_(shaders, "render/wire.vert", "render/wire.frag"),
      back_(shaders.load({"render/surface.vert", "render/back.frag"})),
      layout_("surface vertices"),
      empty_("pulled vertices") {
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexArrayAttrib(layout_.name(), attribute);
        glVertexArrayAttribFormat(layout_.name(), attribute, 4, GL_FLOAT, GL_FALSE,
                                  static_cast<GLuint>(attribute * sizeof(glm::vec4)));
        glVertexArrayAttribBinding(layout_.name(), attribute, 0);
    }
    glVertexArrayAttribFormat(layout_.name(), kPeak, 1, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(layout_.name(), kPeak, kPeak);
}

void SurfacePainter::draw(const SceneView& scene, const LookParameters& look, int firstView, const RenderTarget& target,
                          const Viewport& viewport) {
    const SurfaceKind kind =
        scene.looks != nullptr ? physicalKind(*scene.looks) : presetKind(static_cast<MaterialLook>(look.material));
    const bool translucent = look.colours == kMaterialColours && kind != SurfaceKind::metal;
    if (translucent) drawFarSide(scene.mesh, firstView, target, viewport);
    if (!scene.meshIsOpen) glEnable(GL_CULL_FACE);
    const TonedProgram& program = look.colours != kMaterialColours ? temperature_
                                  : kind == SurfaceKind::ice       ? ice_
                                  : kind == SurfaceKind::wax       ? wax_
                                  : scene.temperature.kelvin       ? hotMetal_
                                                                   : metal_;
    drawMesh(scene.mesh, program.use(target), firstView);
    glDisable(GL_CULL_FACE);
}

void SurfacePainter::drawWireframe(const SurfaceMesh& mesh, int firstView, const RenderTarget& target) const {
    const gl::Program& program = wire_.use(target);
    program.set("firstView", firstView);
    empty_.bind();
    mesh.vertices->bindStorage(PULL_VERTICES_BINDING);
    mesh.indices->bindStorage(PULL_INDICES_BINDING);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, mesh.drawCommand->name());
    // The command for indexed drawing begins like one for plain drawing: count, instances, first; baseVertex, which is
    // 0, stands where the first instance is read.
    glDrawArraysIndirect(GL_TRIANGLES, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void SurfacePainter::drawFarSide(const SurfaceMesh& mesh, int firstView, const RenderTarget& target,
                                 const Viewport& viewport) {
    if (!farSide_ || farSide_->side.shape().width != viewport.width ||
        farSide_->side.shape().height != viewport.height) {
        farSide_.emplace();
        farSide_->side =
            gl::Texture("far side", {.format = GL_RGBA16F, .width = viewport.width, .height = viewport.height});
        farSide_->depth = gl::Texture(
            "far side depth", {.format = GL_DEPTH_COMPONENT32F, .width = viewport.width, .height = viewport.height});
        farSide_->framebuffer.attach(GL_COLOR_ATTACHMENT0, farSide_->side);
        farSide_->framebuffer.attach(GL_DEPTH_ATTACHMENT, farSide_->depth);
        farSide_->framebuffer.requireComplete();
    }
    const std::array<float, 4> nothing{};
    const float farthest = 1.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, farSide_->framebuffer.name());
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glViewport(0, 0, viewport.width, viewport.height);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    drawMesh(mesh, back_, firstView);
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
    farSide_->side.bind(BACK_UNIT);
}

void SurfacePainter::drawMesh(const SurfaceMesh& mesh, const gl::Program& program, int firstView) const {
    program.use();
    program.set("firstView", firstView);
    glVertexArrayVertexBuffer(layout_.name(), 0, mesh.vertices->name(), 0, sizeof(SurfaceVertex));
    glVertexArrayElementBuffer(layout_.name(), mesh.indices->name());
    if (mesh.peaks != nullptr) {
        glVertexArrayVertexBuffer(layout_.name(), kPeak, mesh.peaks->name(), 0, sizeof(float));
        glEnableVertexArrayAttrib(layout_.name(), kPeak);
    } else {
        glDisableVertexArrayAttrib(layout_.name(), kPeak);
        glVertexAttrib1f(kPeak, 0.0f); // nothing was ever hot
    }
    layout_.bind();
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, mesh.drawCommand->name());
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

} // namespace meltpool
