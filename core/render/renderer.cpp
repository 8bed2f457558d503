#include "core/render/renderer.hpp"

#include "core/base/error.hpp"
#include "core/render/environment.hpp"
#include "core/render/frame_block.hpp"
#include "core/render/heat_colours.hpp"
#include "core/render/material_presets.hpp"
#include "core/render/noise.hpp"
#include "core/render/solids.hpp"
#include "core/render/surface_painter.hpp"
#include "core/render/temperature_scale.hpp"
#include "core/render/toned_program.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <string>

namespace meltpool {

namespace {

/// Uniform blocks are written into one buffer after the other, so that a frame under way keeps its own.
constexpr size_t kFramesUnderWay = 3;

void setSwitch(GLenum capability, bool on) {
    (on ? glEnable : glDisable)(capability);
}

Viewport columnOf(const Viewport& whole, size_t column, size_t columns) {
    const int width = whole.width / static_cast<int>(columns);
    return {whole.x + width * static_cast<int>(column), whole.y, width, whole.height};
}

Solid sourceSolid(const SourceView& source, const glm::mat4& modelToWorld) {
    Solid solid;
    const glm::mat4 place = glm::translate(glm::mat4(1.0f), source.position);
    solid.toWorld = modelToWorld * glm::scale(place, glm::vec3(source.size));
    solid.gloss = 0.25f;
    solid.colour = {0.02f, 0.06f, 0.75f};
    if (source.on && source.cold) {
        solid.colour = {0.45f, 0.80f, 0.90f};
        solid.glow = {0.10f, 0.30f, 0.36f};
    } else if (source.on) {
        solid.colour = {0.80f, 0.02f, 0.01f};
        solid.glow = {0.35f, 0.01f, 0.0f};
    }
    return solid;
}

} // namespace

struct Renderer::Parts {
    explicit Parts(gl::ShaderLibrary& shaders);

    void prepare(const SceneView& scene, const LookParameters& look, std::span<const View> views,
                 const RenderTarget& target);
    void drawView(const SceneView& scene, const LookParameters& look, int view, const RenderTarget& target,
                  const Viewport& viewport, gl::Profiler* profiler);
    void drawSolids(const SceneView& scene, const LookParameters& look, int view, const RenderTarget& target) const;
    void drawPoints(const ParticleView& particles, int view, const RenderTarget& target) const;
    void drawSky(int view, const RenderTarget& target) const;
    void drawBox(int view, const RenderTarget& target) const;

    Environment environment;
    gl::Texture scales = makeScaleTexture();
    gl::Texture noise = makeNoiseTexture();
    gl::Texture heat = makeHeatTexture();
    SurfacePainter surface;
    SolidPainter solids;
    SectionPainter section;
    TonedProgram points;
    TonedProgram sky;
    TonedProgram box;
    gl::VertexArray pointLayout{"points"};
    gl::VertexArray empty{"no vertices"};
    std::array<gl::Buffer, kFramesUnderWay> frames;
    std::array<gl::Buffer, kFramesUnderWay> materials;
    size_t current = 0;
};

Renderer::Parts::Parts(gl::ShaderLibrary& shaders)
    : environment(shaders),
      surface(shaders),
      solids(shaders),
      section(shaders),
      points(shaders, "render/points.vert", "render/points.frag"),
      sky(shaders, "render/sky.vert", "render/sky.frag"),
      box(shaders, "render/box.vert", "render/box.frag") {
    for (gl::Buffer& buffer : frames)
        buffer = gl::Buffer("frame block", sizeof(FrameData));
    for (gl::Buffer& buffer : materials)
        buffer = gl::Buffer("material block", sizeof(MaterialData));
    glEnableVertexArrayAttrib(pointLayout.name(), 0);
    glVertexArrayAttribFormat(pointLayout.name(), 0, 4, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(pointLayout.name(), 0, 0);
}

void Renderer::Parts::prepare(const SceneView& scene, const LookParameters& look, std::span<const View> views,
                              const RenderTarget& target) {
    current = (current + 1) % kFramesUnderWay;
    FrameData frame = makeFrame(scene, look);
    for (size_t i = 0; i < views.size(); ++i)
        frame.views[i] = makeViewData(views[i], columnOf(target.viewport, i, views.size()));
    frames[current].writeValue(frame);
    frames[current].bindUniform(FRAME_BINDING);
    materials[current].writeValue(scene.looks != nullptr ? physicalMaterial(*scene.looks)
                                                         : presetMaterial(static_cast<MaterialLook>(look.material)));
    materials[current].bindUniform(MATERIAL_BINDING);
    environment.bind();
    scales.bind(SCALE_UNIT);
    noise.bind(NOISE_UNIT);
    heat.bind(HEAT_UNIT);
}

void Renderer::Parts::drawView(const SceneView& scene, const LookParameters& look, int view, const RenderTarget& target,
                               const Viewport& viewport, gl::Profiler* profiler) {
    const bool meshThere = scene.mesh.vertices != nullptr;
    const bool surfaceShown = look.mode == kSurfaceMode && meshThere;
    setSwitch(GL_CLIP_DISTANCE0, scene.section.shown);
    if (surfaceShown) {
        const gl::Scope scope(profiler, "draw surface");
        surface.draw(scene, look, view, target, viewport);
    }
    if (look.mode == kPointsMode && scene.particles.positions != nullptr) {
        const gl::Scope scope(profiler, "draw points");
        drawPoints(scene.particles, view, target);
    }
    glDisable(GL_CLIP_DISTANCE0);
    if (scene.section.shown) {
        const gl::Scope scope(profiler, "draw section");
        section.draw(scene.section, view, target);
    }
    drawSolids(scene, look, view, target);
    if (look.showSky) {
        const gl::Scope scope(profiler, "draw sky");
        drawSky(view, target);
    }
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    if (look.mode == kWireframeMode && meshThere) {
        const gl::Scope scope(profiler, "draw wireframe");
        setSwitch(GL_CLIP_DISTANCE0, scene.section.shown);
        surface.drawWireframe(scene.mesh, view, target);
        glDisable(GL_CLIP_DISTANCE0);
    }
    if (look.showBox) {
        const gl::Scope scope(profiler, "draw box");
        drawBox(view, target);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void Renderer::Parts::drawSolids(const SceneView& scene, const LookParameters& look, int view,
                                 const RenderTarget& target) const {
    glEnable(GL_CULL_FACE);
    if (look.showSource && scene.source.shown) {
        const Solid source = sourceSolid(scene.source, scene.modelToWorld);
        solids.draw({&source, 1}, view, target);
    }
    if (!scene.solids.empty()) solids.draw(scene.solids, view, target);
    glDisable(GL_CULL_FACE);
}

void Renderer::Parts::drawPoints(const ParticleView& particles, int view, const RenderTarget& target) const {
    glEnable(GL_PROGRAM_POINT_SIZE);
    const gl::Program& program = points.use(target);
    program.set("firstView", view);
    glVertexArrayVertexBuffer(pointLayout.name(), 0, particles.positions->name(), 0, sizeof(glm::vec4));
    pointLayout.bind();
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(particles.count));
    glDisable(GL_PROGRAM_POINT_SIZE);
}

void Renderer::Parts::drawSky(int view, const RenderTarget& target) const {
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    const gl::Program& program = sky.use(target);
    program.set("firstView", view);
    empty.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

void Renderer::Parts::drawBox(int view, const RenderTarget& target) const {
    constexpr int kEdges = 12;
    const gl::Program& program = box.use(target);
    program.set("firstView", view);
    empty.bind();
    glDrawArrays(GL_TRIANGLES, 0, kEdges * 6);
}

Renderer::Renderer(gl::ShaderLibrary& shaders) : parts_(std::make_unique<Parts>(shaders)) {}

Renderer::~Renderer() = default;

SectionZone Renderer::measureSection(double peak, double level) const {
    return parts_->section.measure(peak, level);
}

void Renderer::draw(const SceneView& scene, const LookParameters& look, std::span<const View> views,
                    const RenderTarget& target, gl::Profiler* profiler) {
    if (views.empty() || views.size() > kMostViews)
        throw RuntimeFault("the renderer draws 1 to " + std::to_string(kMostViews) + " views at once, not " +
                           std::to_string(views.size()));
    const gl::Scope scope(profiler, "draw");
    parts_->prepare(scene, look, views, target);
    if (scene.section.shown) {
        const gl::Scope gathering(profiler, "gather section");
        parts_->section.gather(scene.section, scene.particles, scene.boxMin, scene.boxMax);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    setSwitch(GL_FRAMEBUFFER_SRGB, target.encodesSrgb);
    glViewport(target.viewport.x, target.viewport.y, target.viewport.width, target.viewport.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(target.viewport.x, target.viewport.y, target.viewport.width, target.viewport.height);
    glClearColor(0.02f, 0.02f, 0.022f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    for (size_t i = 0; i < views.size(); ++i) {
        const Viewport viewport = columnOf(target.viewport, i, views.size());
        glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
        parts_->drawView(scene, look, static_cast<int>(i), target, viewport, profiler);
    }
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

} // namespace meltpool
