#include "core/render/effects_painter.hpp"

#include "core/render/look/measures.hpp"

namespace meltpool {

namespace {

/// As long as they are needed for: all that an arc throws at once.
constexpr size_t kRoom = 1024;

bool showsEffects(const SceneView& scene, const LookParameters& look) {
    return look.colours == kMaterialColours && look.mode == kSurfaceMode && look.showSource && !scene.section.shown;
}

} // namespace

EffectsPainter::EffectsPainter(gl::ShaderLibrary& shaders)
    : sparks_(shaders, "render/spark.vert", "render/spark.frag"),
      haze_(shaders, "render/haze.vert", "render/haze.frag"),
      afterImage_(shaders, "render/after_image.vert", "render/after_image.frag"),
      empty_("sparks") {
    for (gl::Buffer& buffer : buffers_)
        buffer = gl::Buffer("sparks", kRoom * sizeof(Spark));
}

void EffectsPainter::upload(const SceneView& scene, const LookParameters& look) {
    const bool shown = showsEffects(scene, look);
    const ArcEffectsView& effects = scene.effects;
    scattering_ =
        shown && look.fume && has(look, Measure::fume) && scene.arc.intensity.g > 0 ? effects.fume.scattering : 0;
    count_ = 0;
    if (!shown || !look.spatter || !has(look, Measure::spatter)) return;
    const size_t all =
        scene.tableShown && has(look, Measure::room) ? effects.sparks.size() : effects.sparks.size() - effects.onTable;
    count_ = std::min(all, kRoom);
    if (count_ == 0) return;
    current_ = (current_ + 1) % buffers_.size();
    buffers_[current_].write(effects.sparks.first(count_));
}

void EffectsPainter::drawSparks(const ViewBatch& views, const RenderTarget& target) const {
    if (count_ == 0) return;
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); // the shader has multiplied by the cover
    sparks_.use(target, views);
    buffers_[current_].bindStorage(SPARKS_BINDING);
    empty_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * count_), views.count);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

/// Adds what leaves the picture below white, as the glare does.
void EffectsPainter::drawHaze(const ViewBatch& views, const RenderTarget& target) const {
    if (scattering_ <= 0) return;
    glDisable(GL_DEPTH_TEST);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
    haze_.use(target, views).set("scattering", scattering_);
    empty_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, views.count);
    glEnable(GL_DEPTH_TEST);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void EffectsPainter::drawAfterImage(const AfterImage& image, const ViewBatch& views, const RenderTarget& target) const {
    if (image.strength <= 0) return;
    glDisable(GL_DEPTH_TEST);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const gl::Program& program = afterImage_.use(target, views);
    program.set("towards", image.towards);
    program.set("strength", image.strength);
    empty_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, views.count);
    glEnable(GL_DEPTH_TEST);
}

} // namespace meltpool
