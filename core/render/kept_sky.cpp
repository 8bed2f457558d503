#include "core/render/kept_sky.hpp"

namespace meltpool {

namespace {

/// Returns true for a target with one sample: a copy into several samples would lose the sky in the samples of an edge.
bool hasOneSample(const RenderTarget& target) {
    GLint samples = 0;
    glGetNamedFramebufferParameteriv(target.framebuffer, GL_SAMPLES, &samples);
    return samples < 2;
}

} // namespace

KeptSky::State KeptSky::look(const SkyKey& key, const RenderTarget& target) {
    const bool corner = target.viewport.x == 0 && target.viewport.y == 0; // a corner, as of every window and picture
    if (key != key_ || !corner) {
        key_ = key;
        picture_.reset();
        return State::other;
    }
    if (picture_) return State::kept;
    return hasOneSample(target) ? State::due : State::other;
}

RenderTarget KeptSky::begin() {
    picture_.emplace();
    const GLenum format = key_.encodesSrgb ? GL_SRGB8_ALPHA8 : GL_RGBA8;
    picture_->colour = gl::Texture("kept sky", {.format = format, .width = key_.width, .height = key_.height});
    picture_->framebuffer.attach(GL_COLOR_ATTACHMENT0, picture_->colour);
    picture_->framebuffer.requireComplete();
    return {picture_->framebuffer.name(), {0, 0, key_.width, key_.height}, key_.encodesSrgb};
}

void KeptSky::copyTo(const RenderTarget& target) const {
    glDisable(GL_FRAMEBUFFER_SRGB); // copies the bytes unchanged
    glBlitNamedFramebuffer(picture_->framebuffer.name(), target.framebuffer, 0, 0, key_.width, key_.height, 0, 0,
                           key_.width, key_.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace meltpool
