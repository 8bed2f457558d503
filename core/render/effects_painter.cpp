#include "core/render/effects_painter.hpp"

#include "core/render/effects/fume_puffs.hpp"
#include "core/render/look/measures.hpp"

namespace meltpool {

namespace {

/// Buffer size in effects, enough for all that an arc throws at once.
constexpr size_t kRoom = 1024;

bool showsEffects(const SceneView& scene, const LookParameters& look) {
    return look.colours == kMaterialColours && look.mode == kSurfaceMode && look.showSource && !scene.section.shown;
}

} // namespace

EffectsPainter::EffectsPainter(gl::ShaderLibrary& shaders)
    : sparks_(shaders, "render/spark.vert", "render/spark.frag"),
      haze_(shaders, "render/haze.vert", "render/haze.frag"),
      fume_(shaders, "render/fume.vert", "render/fume.frag"),
      afterImage_(shaders, "render/after_image.vert", "render/after_image.frag"),
      empty_("sparks") {
    for (gl::Buffer& buffer : buffers_)
        buffer = gl::Buffer("sparks", kRoom * sizeof(Spark));
    for (gl::Buffer& buffer : puffBuffers_)
        buffer = gl::Buffer("fume", FumePuffs::kMost * sizeof(FumePuff));
}

void EffectsPainter::upload(const SceneView& scene, const LookParameters& look) {
    current_ = (current_ + 1) % buffers_.size();
    uploadSparks(scene, look);
    uploadFume(scene, look);
}

void EffectsPainter::uploadSparks(const SceneView& scene, const LookParameters& look) {
    count_ = 0;
    if (!showsEffects(scene, look) || !look.spatter || !has(look, DetailFeature::spatter)) return;
    const ArcEffectsView& effects = scene.effects;
    const size_t all = scene.tableShown && has(look, DetailFeature::room) ? effects.sparks.size()
                                                                          : effects.sparks.size() - effects.onTable;
    count_ = std::min(all, kRoom);
    if (count_ > 0) buffers_[current_].write(effects.sparks.first(count_));
}

void EffectsPainter::uploadFume(const SceneView& scene, const LookParameters& look) {
    const bool shown = showsEffects(scene, look) && look.fume && has(look, DetailFeature::fume);
    const Fume& fume = scene.effects.fume;
    scattering_ = shown && scene.arc.intensity.g > 0 ? fume.scattering : 0;
    puffs_ = shown ? std::min(fume.puffs.size(), FumePuffs::kMost) : 0;
    if (puffs_ == 0) return;
    puffBuffers_[current_].write(fume.puffs.first(puffs_));
    pool_ = fume.pool;
    tableTop_ = scene.tableShown && has(look, DetailFeature::room) ? scene.tableTop : -1e9f;
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

void EffectsPainter::drawFume(const ViewBatch& views, const RenderTarget& target) const {
    if (puffs_ == 0) return;
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); // the shader has multiplied by the cover
    const gl::Program& program = fume_.use(target, views);
    program.set("pool", pool_);
    program.set("tableTop", tableTop_);
    puffBuffers_[current_].bindStorage(FUME_BINDING);
    empty_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * puffs_), views.count);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

/// Adds the light that leaves the picture below white, as the glare does.
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
