#include "core/render/renderer.hpp"

#include "core/base/error.hpp"
#include "core/render/effects_painter.hpp"
#include "core/render/frame_block.hpp"
#include "core/render/hidden_area_painter.hpp"
#include "core/render/kept_sky.hpp"
#include "core/render/line_of_sight.hpp"
#include "core/render/look/environment.hpp"
#include "core/render/look/heat_colours.hpp"
#include "core/render/look/material_presets.hpp"
#include "core/render/look/measures.hpp"
#include "core/render/look/mirror_shares.hpp"
#include "core/render/look/noise.hpp"
#include "core/render/look/temperature_scale.hpp"
#include "core/render/solids.hpp"
#include "core/render/source_model.hpp"
#include "core/render/stroke_painter.hpp"
#include "core/render/surface_painter.hpp"
#include "core/render/toned_program.hpp"
#include "core/render/workshop_painter.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <string>

namespace meltpool {

namespace {

/// Frames use their uniform buffers in turn, so that writing one does not wait for frames that the GPU still draws.
constexpr size_t kFramesInFlight = 3;

void setSwitch(GLenum capability, bool on) {
    (on ? glEnable : glDisable)(capability);
}

} // namespace

struct Renderer::Parts {
    Parts(gl::ShaderLibrary& shaders, const std::filesystem::path& kept);

    void load(ViewSubmission submission);
    const SubmissionChoice& choose(std::optional<ViewSubmission> best);
    ViewSubmission submissionFor(size_t views);
    void prepare(const SceneView& scene, const LookParameters& look, std::span<const View> views,
                 const RenderTarget& target);
    void drawBatch(const SceneView& scene, const LookParameters& look, const ViewBatch& views, int count,
                   const RenderTarget& target, gl::Profiler* profiler);
    void gatherSolids(const SceneView& scene, const LookParameters& look, std::span<const View> views);
    void gatherFittings(const SceneView& scene, std::span<const View> views);
    void drawMarkers(const SceneView& scene, const ViewBatch& views, const RenderTarget& target,
                     gl::Profiler* profiler) const;
    void drawPoints(const ParticleView& particles, const ViewBatch& views, const RenderTarget& target) const;
    void drawSky(const ViewBatch& views, const RenderTarget& target) const;
    void keepSky(const LookParameters& look, std::span<const View> views, const RenderTarget& target);
    void clear(const RenderTarget& target) const;
    void drawBox(const ViewBatch& views, const RenderTarget& target) const;
    void drawGlare(const ViewBatch& views, const RenderTarget& target) const;

    Environment environment;
    gl::Texture scales = makeScaleTexture();
    gl::Texture noise = makeNoiseTexture();
    gl::Texture heat = makeHeatTexture();
    gl::Texture mirrorShares = makeMirrorShareTexture();
    SurfacePainter surface;
    SolidPainter solids;
    SectionPainter section;
    StrokePainter strokes;
    SourceModel source; ///< of this frame
    EffectsPainter effects;
    WorkshopPainter room;
    HiddenAreaPainter hidden;
    TonedProgram points;
    TonedProgram sky;
    TonedProgram box;
    TonedProgram glare;
    gl::VertexArray pointLayout{"points"};
    gl::VertexArray empty{"no vertices"};
    std::array<gl::Buffer, kFramesInFlight> frames;
    std::array<gl::Buffer, kFramesInFlight> materials;
    size_t current = 0;
    bool roomShown = false;                 ///< shown in this frame
    KeptSky stillSky;                       ///< sky behind a camera that does not move
    bool skyCopied = false;                 ///< copied in this frame
    glm::vec3 exposure{0};                  ///< exposure of this frame, through the filter
    std::optional<SubmissionChoice> choice; ///< way in which several views are submitted; its programs are loaded
    std::optional<ViewSubmission> wanted;   ///< value of `wanted` that `choice` was made for
};

Renderer::Parts::Parts(gl::ShaderLibrary& shaders, const std::filesystem::path& kept)
    : environment(shaders, kept),
      surface(shaders),
      solids(shaders),
      section(shaders),
      strokes(shaders),
      effects(shaders),
      room(shaders),
      hidden(shaders),
      points(shaders, "render/points.vert", "render/points.frag"),
      sky(shaders, "render/sky.vert", "render/sky.frag"),
      box(shaders, "render/box.vert", "render/box.frag"),
      glare(shaders, "render/glare.vert", "render/glare.frag") {
    for (gl::Buffer& buffer : frames)
        buffer = gl::Buffer("frame block", sizeof(FrameData));
    for (gl::Buffer& buffer : materials)
        buffer = gl::Buffer("material block", sizeof(MaterialData));
    for (const GLuint attribute : {POSITION_ATTRIBUTE, TEMPERATURE_ATTRIBUTE}) {
        glEnableVertexArrayAttrib(pointLayout.name(), attribute);
        glVertexArrayAttribBinding(pointLayout.name(), attribute, 0);
    }
    // A particle is a vec4: position and temperature.
    glVertexArrayAttribFormat(pointLayout.name(), POSITION_ATTRIBUTE, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribFormat(pointLayout.name(), TEMPERATURE_ATTRIBUTE, 1, GL_FLOAT, GL_FALSE, sizeof(glm::vec3));
}

void Renderer::Parts::load(ViewSubmission submission) {
    surface.load(submission);
    solids.load(submission);
    section.load(submission);
    strokes.load(submission);
    effects.load(submission);
    room.load(submission);
    for (TonedProgram* program : {&points, &sky, &box, &glare})
        program->load(submission);
}

const SubmissionChoice& Renderer::Parts::choose(std::optional<ViewSubmission> best) {
    if (choice && wanted == best) return *choice;
    wanted = best;
    std::string refusals;
    for (;;) {
        choice = chooseSubmission(best, submissionOffer(), kMostViews);
        choice->sentence += refusals;
        try {
            load(choice->submission);
            return *choice;
        } catch (const InputError& fault) {
            if (choice->submission == ViewSubmission::passes) throw;
            refusals += std::string("; the graphics driver refuses the shaders for ") +
                        std::string(submissionName(choice->submission)) + " (" + fault.what() + ")";
            best = static_cast<ViewSubmission>(static_cast<int>(choice->submission) + 1);
        }
    }
}

ViewSubmission Renderer::Parts::submissionFor(size_t views) {
    if (views < 2) return ViewSubmission::passes;
    return choice ? choice->submission : choose(std::nullopt).submission;
}

void Renderer::Parts::prepare(const SceneView& scene, const LookParameters& look, std::span<const View> views,
                              const RenderTarget& target) {
    current = (current + 1) % kFramesInFlight;
    FrameData frame = makeFrame(scene, look);
    const auto count = static_cast<int>(views.size());
    frame.viewCount = static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
        const View& view = views[static_cast<size_t>(i)];
        frame.views[i] = makeViewData(view, columnOf(target.viewport, i, count));
        frame.views[i].arcSeen = arcPastHands(scene, view.eye);
    }
    exposure = frame.exposure;
    frames[current].writeValue(frame);
    frames[current].bindUniform(FRAME_BINDING);
    materials[current].writeValue(scene.looks != nullptr ? physicalMaterial(*scene.looks, scene.ripples)
                                                         : presetMaterial(static_cast<MaterialLook>(look.material)));
    materials[current].bindUniform(MATERIAL_BINDING);
    environment.bind();
    scales.bind(SCALE_UNIT);
    noise.bind(NOISE_UNIT);
    heat.bind(HEAT_UNIT);
    mirrorShares.bind(MIRROR_SHARE_UNIT);
    roomShown = look.showSky && has(look, DetailFeature::room) && scene.room.shown && insideRoom(scene.room, views);
    gatherSolids(scene, look, views);
}

void Renderer::Parts::drawBatch(const SceneView& scene, const LookParameters& look, const ViewBatch& views, int count,
                                const RenderTarget& target, gl::Profiler* profiler) {
    aim(views, target.viewport, count);
    const bool clipped = views.submission == ViewSubmission::clipping;
    setSwitch(GL_CLIP_DISTANCE0, clipped);
    setSwitch(GL_CLIP_DISTANCE1, clipped);
    const GLenum cut = cutPlane(views.submission);
    const bool meshThere = scene.mesh.vertices != nullptr;
    const bool surfaceShown = look.mode == kSurfaceMode && meshThere;
    setSwitch(cut, scene.section.shown);
    if (surfaceShown) {
        const gl::Scope scope(profiler, "draw surface");
        surface.draw(scene, look, views, count, target);
    }
    if (look.mode == kPointsMode && scene.particles.positions != nullptr) {
        const gl::Scope scope(profiler, "draw points");
        drawPoints(scene.particles, views, target);
    }
    glDisable(cut);
    if (scene.section.shown) {
        const gl::Scope scope(profiler, "draw section");
        section.draw(scene.section, views, target);
    }
    glEnable(GL_CULL_FACE);
    solids.draw(views, target);
    glDisable(GL_CULL_FACE);
    if (roomShown) {
        const gl::Scope scope(profiler, "draw room");
        room.draw(scene.room, views, target);
    } else if (look.showSky && !skyCopied) {
        const gl::Scope scope(profiler, "draw sky");
        drawSky(views, target);
    }
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    if (look.mode == kWireframeMode && meshThere) {
        const gl::Scope scope(profiler, "draw wireframe");
        setSwitch(cut, scene.section.shown);
        surface.drawWireframe(scene.mesh, views, target);
        glDisable(cut);
    }
    if (look.showBox) {
        const gl::Scope scope(profiler, "draw box");
        drawBox(views, target);
    }
    if (effects.shows()) {
        const gl::Scope scope(profiler, "draw effects");
        effects.drawFume(views, target);
        effects.drawSparks(views, target);
        effects.drawHaze(views, target);
    }
    if (scene.section.shown) strokes.draw(scene.section.at + scene.section.lift, views, target);
    drawMarkers(scene, views, target, profiler);
    if (scene.arc.intensity.g > 0 && has(look, DetailFeature::glare)) {
        const gl::Scope scope(profiler, "draw glare");
        drawGlare(views, target);
    }
    effects.drawAfterImage(scene.afterImage, views, target);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_CLIP_DISTANCE0);
    glDisable(GL_CLIP_DISTANCE1);
}

void Renderer::Parts::drawMarkers(const SceneView& scene, const ViewBatch& views, const RenderTarget& target,
                                  gl::Profiler* profiler) const {
    if (source.markers.empty() && scene.ghost.empty() && scene.markers.empty()) return;
    const gl::Scope scope(profiler, "draw markers");
    glEnable(GL_CULL_FACE);
    solids.draw(source.markers, views, target);
    solids.draw(scene.ghost, views, target);
    solids.draw(scene.markers, views, target);
    glDisable(GL_CULL_FACE);
}

/// A free camera goes through places that a person's head would avoid, and looks through hand and handle there. Both
/// eyes of a head see them at their places.
void Renderer::Parts::gatherFittings(const SceneView& scene, std::span<const View> views) {
    constexpr float kMargin = 0.008f, kHead = 0.06f; // m; the torch's head over its tip is visible from every place
    // Dull solids have no highlight that needs every pixel.
    constexpr float kDull = 0.3f;
    const auto gather = [&](const Solid& fitting) { solids.gather({&fitting, 1}, fitting.gloss < kDull); };
    if (views.size() > 1 || scene.solids.empty()) {
        std::ranges::for_each(scene.fittings, gather);
        return;
    }
    const float metre = glm::length(glm::vec3(scene.room.toWorld[0]));
    const glm::vec3 eye = views.front().eye, tip = scene.solids.front().toWorld * glm::vec4(0, 0, -0.5f, 1);
    const float far = glm::distance(eye, tip);
    const glm::vec3 head = glm::mix(tip, eye, std::min(kHead * metre / std::max(far, 1e-6f), 1.0f));
    for (const Solid& fitting : scene.fittings)
        if (!standsBefore(fitting, eye, head, kMargin * metre)) gather(fitting);
}

void Renderer::Parts::gatherSolids(const SceneView& scene, const LookParameters& look, std::span<const View> views) {
    solids.begin();
    if (look.showSource && scene.source.shown) {
        buildSource(source, scene.source, scene.modelToWorld);
        solids.gather(source.solids);
    } else {
        source.markers.clear();
    }
    for (Solid mark : scene.section.shown ? std::span<const Solid>() : scene.chalk) {
        mark.toWorld = scene.modelToWorld * mark.toWorld;
        solids.gather({&mark, 1});
    }
    const DetailFeature shows = scene.hands.empty() ? DetailFeature::fittings : DetailFeature::room;
    const bool fine = has(look, shows) && !scene.fittings.empty();
    solids.gather(scene.solids, false, !fine);
    if (fine) gatherFittings(scene, views);
    // Furniture is left out without the room, and with a room that is not visible.
    if (has(look, DetailFeature::room) && roomShown == scene.room.shown) solids.gather(scene.furniture, true);
    solids.upload();
}

void Renderer::Parts::drawPoints(const ParticleView& particles, const ViewBatch& views,
                                 const RenderTarget& target) const {
    glEnable(GL_PROGRAM_POINT_SIZE);
    points.use(target, views);
    glVertexArrayVertexBuffer(pointLayout.name(), 0, particles.positions->name(), 0, sizeof(glm::vec4));
    pointLayout.bind();
    glDrawArraysInstanced(GL_POINTS, 0, static_cast<GLsizei>(particles.count), views.count);
    glDisable(GL_PROGRAM_POINT_SIZE);
}

void Renderer::Parts::drawSky(const ViewBatch& views, const RenderTarget& target) const {
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    sky.use(target, views);
    empty.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 3, views.count);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

/// The room has depths, which later things are behind: it is drawn each time.
void Renderer::Parts::keepSky(const LookParameters& look, std::span<const View> views, const RenderTarget& target) {
    skyCopied = false;
    if (!look.showSky || roomShown || views.size() > 1) return;
    const View& view = views.front();
    const SkyKey key{view.worldToEye,        view.eyeToClip,     exposure,           target.viewport.width,
                     target.viewport.height, target.encodesSrgb, target.framebuffer, sky.use(target, {}).name()};
    skyCopied = stillSky.prepare(key, target, [&](const RenderTarget& own) {
        setSwitch(GL_FRAMEBUFFER_SRGB, own.encodesSrgb);
        glDisable(GL_SCISSOR_TEST);
        glBindFramebuffer(GL_FRAMEBUFFER, own.framebuffer);
        glViewport(0, 0, own.viewport.width, own.viewport.height);
        drawSky({}, own);
    });
}

void Renderer::Parts::clear(const RenderTarget& target) const {
    if (skyCopied) stillSky.copyTo(target);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    setSwitch(GL_FRAMEBUFFER_SRGB, target.encodesSrgb);
    glViewport(target.viewport.x, target.viewport.y, target.viewport.width, target.viewport.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(target.viewport.x, target.viewport.y, target.viewport.width, target.viewport.height);
    glClearColor(0.02f, 0.02f, 0.022f, 1.0f);
    glClear(skyCopied ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// Draws the glare over everything: it is light inside the eye. Adds the light that leaves the picture below white, so
/// that it also serves targets whose values the shaders encode.
void Renderer::Parts::drawGlare(const ViewBatch& views, const RenderTarget& target) const {
    glDisable(GL_DEPTH_TEST);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
    glare.use(target, views);
    empty.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, views.count);
    glEnable(GL_DEPTH_TEST);
}

void Renderer::Parts::drawBox(const ViewBatch& views, const RenderTarget& target) const {
    constexpr int kEdges = 12;
    box.use(target, views);
    empty.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, kEdges * 6, views.count);
}

Renderer::Renderer(gl::ShaderLibrary& shaders, const std::filesystem::path& kept)
    : parts_(std::make_unique<Parts>(shaders, kept)) {}

Renderer::~Renderer() = default;

const SubmissionChoice& Renderer::submitBy(std::optional<ViewSubmission> wanted) {
    return parts_->choose(wanted);
}

const gl::Texture& Renderer::environment() const {
    return parts_->environment.texture();
}

void Renderer::draw(const SceneView& scene, const LookParameters& look, std::span<const View> views,
                    const RenderTarget& target, gl::Profiler* profiler) {
    if (views.empty() || views.size() > kMostViews)
        throw RuntimeFault("the renderer was given " + std::to_string(views.size()) + " views; expected 1 to " +
                           std::to_string(kMostViews));
    const gl::Scope scope(profiler, "draw");
    const ViewSubmission submission = parts_->submissionFor(views.size());
    parts_->prepare(scene, look, views, target);
    if (scene.section.shown) {
        const gl::Scope uploading(profiler, "upload section");
        parts_->section.upload(scene.section);
        parts_->strokes.upload(scene.section.strokes);
    }
    parts_->effects.upload(scene, look);
    parts_->keepSky(look, views, target);
    parts_->clear(target);
    parts_->hidden.draw(views, target);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    const auto count = static_cast<int>(views.size());
    const int together = submission == ViewSubmission::passes ? 1 : count;
    parts_->surface.prepare(scene, look, together);
    parts_->solids.prepare(measuresOf(look));
    for (int first = 0; first < count; first += together)
        parts_->drawBatch(scene, look, {first, together, submission}, count, target, profiler);
    parts_->hidden.blacken(views, target);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

void Renderer::drawOver(std::span<const Marker> markers, const RenderTarget& target) {
    if (markers.empty()) return;
    const ViewBatch first;
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    setSwitch(GL_FRAMEBUFFER_SRGB, target.encodesSrgb);
    aim(first, target.viewport, 1);
    glEnable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    parts_->solids.draw(markers, first, target);
    for (const GLenum capability : {GL_CULL_FACE, GL_BLEND, GL_SCISSOR_TEST, GL_FRAMEBUFFER_SRGB})
        glDisable(capability);
}

} // namespace meltpool
