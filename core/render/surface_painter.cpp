#include "core/render/surface_painter.hpp"

#include "core/render/look/measures.hpp"
#include "shaders/shared/render.h"
#include "shaders/shared/surface.h"

#include <array>
#include <cstddef>

namespace meltpool {

namespace {

constexpr GLuint kVertexBuffer = 0, kPeakBuffer = 1, kFreezingBuffer = 2; // bindings of the vertex array
constexpr std::array<GLuint, MOST_VIEWS + 1> kCounts{0, 1, 2, 3, 4};
const std::vector<std::pair<unsigned, std::string>> kOfHotMetal{{bitOf(DetailFeature::torchShadow), "TORCH_SHADOW"},
                                                                {bitOf(DetailFeature::roughLobes), "ROUGH_LOBES"},
                                                                {bitOf(DetailFeature::calmHighlights), "SPECULAR_AA"},
                                                                {bitOf(DetailFeature::ripples), "RIPPLES"},
                                                                {bitOf(DetailFeature::millScale), "MILL_SCALE"}};

std::vector<std::pair<unsigned, std::string>> ofPool() {
    auto measures = kOfHotMetal;
    measures.emplace_back(bitOf(DetailFeature::floatingOxide), "FLOATING_OXIDE");
    return measures;
}

SurfaceKind kindOf(const SceneView& scene, const LookParameters& look) {
    return scene.looks != nullptr ? physicalKind(*scene.looks) : presetKind(static_cast<MaterialLook>(look.material));
}

bool isHotMetal(const SceneView& scene, const LookParameters& look) {
    return look.colours == kMaterialColours && kindOf(scene, look) == SurfaceKind::metal && scene.temperature.kelvin;
}

} // namespace

SurfacePainter::SurfacePainter(gl::ShaderLibrary& shaders)
    : metal_(shaders, "render/metal.vert", "render/metal.frag"),
      hotMetal_(shaders, "render/hot_metal.vert", "render/hot_metal.frag", kOfHotMetal, {{"DRAWN_TWICE", "1"}}),
      pool_(shaders, "render/hot_metal.vert", "render/hot_metal.frag", ofPool(), {{"DRAWN_TWICE", "1"}, {"POOL", "1"}}),
      wax_(shaders, "render/surface.vert", "render/wax.frag"),
      ice_(shaders, "render/surface.vert", "render/ice.frag"),
      temperature_(shaders, "render/temperature.vert", "render/temperature.frag"),
      wire_(shaders, "render/wire.vert", "render/wire.frag"),
      back_(shaders, "render/surface.vert", "render/back.frag"),
      oxide_(shaders),
      layout_("surface vertices"),
      empty_("pulled vertices"),
      command_("surface draw command", sizeof(SurfaceDraw)),
      counts_("instance counts", std::span<const GLuint>(kCounts)) {
    addVertexAttribute(POSITION_ATTRIBUTE, 3, offsetof(SurfaceVertex, position));
    addVertexAttribute(NORMAL_ATTRIBUTE, 3, offsetof(SurfaceVertex, normal));
    addVertexAttribute(TEMPERATURE_ATTRIBUTE, 1, offsetof(SurfaceVertex, temperature));
    glVertexArrayAttribFormat(layout_.name(), PEAK_ATTRIBUTE, 1, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(layout_.name(), PEAK_ATTRIBUTE, kPeakBuffer);
    glVertexArrayAttribFormat(layout_.name(), FREEZING_ATTRIBUTE, 4, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(layout_.name(), FREEZING_ATTRIBUTE, kFreezingBuffer);
    glVertexArrayAttribFormat(layout_.name(), FROZEN_ATTRIBUTE, 1, GL_FLOAT, GL_FALSE, offsetof(SurfaceVertex, frozen));
    glVertexArrayAttribBinding(layout_.name(), FROZEN_ATTRIBUTE, kVertexBuffer);
}

void SurfacePainter::addVertexAttribute(GLuint attribute, GLint components, size_t offset) {
    glEnableVertexArrayAttrib(layout_.name(), attribute);
    glVertexArrayAttribFormat(layout_.name(), attribute, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(layout_.name(), attribute, kVertexBuffer);
}

void SurfacePainter::load(ViewSubmission submission) {
    for (TonedProgram* program : {&metal_, &wax_, &ice_, &temperature_, &wire_})
        program->load(submission);
    hotMetal_.load(submission);
    pool_.load(submission);
    back_.load(submission);
}

void SurfacePainter::prepare(const SceneView& scene, const LookParameters& look, int instances) {
    if (isHotMetal(scene, look)) {
        rippled_ =
            scene.mesh.freezing != nullptr && has(look, DetailFeature::ripples) && has(look, DetailFeature::roughLobes);
        const bool oxidised =
            scene.oxideRadius > 0 && scene.particles.positions != nullptr && has(look, DetailFeature::floatingOxide);
        const bool scaled = scene.rolled.count > 0 && scene.looks != nullptr && scene.looks->millScale > 0;
        const unsigned measures = measuresOf(look) & ~(rippled_ ? 0u : bitOf(DetailFeature::ripples)) &
                                  ~(oxidised ? 0u : bitOf(DetailFeature::floatingOxide)) &
                                  ~(scaled ? 0u : bitOf(DetailFeature::millScale));
        hotMetal_.choose(measures);
        if (has(look, DetailFeature::poolMirror)) {
            pool_.choose(measures);
            if (oxidised) oxide_.find(scene.particles);
        }
    }
    const SurfaceMesh& mesh = scene.mesh;
    if (instances < 2 || mesh.drawCommand == nullptr) return;
    // The draw command of the mesh has one instance, and only the GPU knows its size.
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    mesh.drawCommand->copyTo(command_, sizeof(SurfaceDraw));
    counts_.copyTo(command_, sizeof(GLuint), static_cast<size_t>(instances) * sizeof(GLuint),
                   offsetof(SurfaceDraw, instances));
}

const gl::Buffer& SurfacePainter::commandFor(const SurfaceMesh& mesh, const ViewBatch& views) const {
    return views.count > 1 ? command_ : *mesh.drawCommand;
}

void SurfacePainter::draw(const SceneView& scene, const LookParameters& look, const ViewBatch& views, int count,
                          const RenderTarget& target) {
    const SurfaceKind kind = kindOf(scene, look);
    const bool translucent = look.colours == kMaterialColours && kind != SurfaceKind::metal;
    if (translucent) drawFarSide(scene.mesh, views, count, target);
    if (!scene.meshIsOpen) glEnable(GL_CULL_FACE);
    const bool coloured = look.colours != kMaterialColours;
    if (isHotMetal(scene, look)) {
        drawHotMetal(scene.mesh, look, views, target);
    } else {
        const TonedProgram& program = coloured                   ? temperature_
                                      : kind == SurfaceKind::ice ? ice_
                                      : kind == SurfaceKind::wax ? wax_
                                                                 : metal_;
        program.use(target, views);
        drawMesh(scene.mesh, views);
    }
    glDisable(GL_CULL_FACE);
}

void SurfacePainter::drawHotMetal(const SurfaceMesh& mesh, const LookParameters& look, const ViewBatch& views,
                                  const RenderTarget& target) const {
    if (rippled_) bindFreezing(mesh);
    hotMetal_.use(target, views);
    drawMesh(mesh, views);
    if (has(look, DetailFeature::poolMirror)) {
        glDepthFunc(GL_LEQUAL);
        pool_.use(target, views);
        drawMesh(mesh, views);
        glDepthFunc(GL_LESS);
    }
    for (const GLuint attribute : {FREEZING_ATTRIBUTE, FROZEN_ATTRIBUTE})
        glDisableVertexArrayAttrib(layout_.name(), attribute);
}

void SurfacePainter::bindFreezing(const SurfaceMesh& mesh) const {
    glVertexArrayVertexBuffer(layout_.name(), kFreezingBuffer, mesh.freezing->name(), 0, sizeof(SurfaceFreezing));
    for (const GLuint attribute : {FREEZING_ATTRIBUTE, FROZEN_ATTRIBUTE})
        glEnableVertexArrayAttrib(layout_.name(), attribute);
}

void SurfacePainter::drawWireframe(const SurfaceMesh& mesh, const ViewBatch& views, const RenderTarget& target) const {
    wire_.use(target, views);
    empty_.bind();
    mesh.vertices->bindStorage(PULL_VERTICES_BINDING);
    mesh.indices->bindStorage(PULL_INDICES_BINDING);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commandFor(mesh, views).name());
    // The command of indexed drawing serves unindexed drawing: count, instances and first match, and baseVertex, which
    // is 0, is read as the first instance.
    glDrawArraysIndirect(GL_TRIANGLES, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void SurfacePainter::fitFarSide(int width, int height) {
    if (farSide_ && farSide_->side.shape().width == width && farSide_->side.shape().height == height) return;
    farSide_.emplace();
    farSide_->side = gl::Texture("far side", {.format = GL_RGBA16F, .width = width, .height = height});
    farSide_->depth =
        gl::Texture("far side depth", {.format = GL_DEPTH_COMPONENT32F, .width = width, .height = height});
    farSide_->framebuffer.attach(GL_COLOR_ATTACHMENT0, farSide_->side);
    farSide_->framebuffer.attach(GL_DEPTH_ATTACHMENT, farSide_->depth);
    farSide_->framebuffer.requireComplete();
}

void SurfacePainter::drawFarSide(const SurfaceMesh& mesh, const ViewBatch& views, int count,
                                 const RenderTarget& target) {
    const Viewport column = columnOf(target.viewport, 0, count);
    const Viewport all{0, 0, column.width * count, column.height};
    fitFarSide(all.width, all.height);
    const std::array<float, 4> nothing{};
    const float farthest = 1.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, farSide_->framebuffer.name());
    if (views.first == 0) {
        glDisable(GL_SCISSOR_TEST);
        glClearBufferfv(GL_COLOR, 0, nothing.data());
        glClearBufferfv(GL_DEPTH, 0, &farthest);
    }
    aim(views, all, count);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    back_.use(views);
    drawMesh(mesh, views);
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    aim(views, target.viewport, count);
    farSide_->side.bind(BACK_UNIT);
}

void SurfacePainter::drawMesh(const SurfaceMesh& mesh, const ViewBatch& views) const {
    glVertexArrayVertexBuffer(layout_.name(), kVertexBuffer, mesh.vertices->name(), 0, sizeof(SurfaceVertex));
    glVertexArrayElementBuffer(layout_.name(), mesh.indices->name());
    if (mesh.peaks != nullptr) {
        glVertexArrayVertexBuffer(layout_.name(), kPeakBuffer, mesh.peaks->name(), 0, sizeof(float));
        glEnableVertexArrayAttrib(layout_.name(), PEAK_ATTRIBUTE);
    } else {
        glDisableVertexArrayAttrib(layout_.name(), PEAK_ATTRIBUTE);
        glVertexAttrib1f(PEAK_ATTRIBUTE, 0.0f); // no tint
    }
    layout_.bind();
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commandFor(mesh, views).name());
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

} // namespace meltpool
