#include "core/render/picture_target.hpp"

#include <algorithm>

namespace meltpool {

namespace {

int offeredSamples(int wanted) {
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    return std::clamp(wanted, 1, std::max(1, int(most)));
}

gl::Texture makePlain(std::string_view label, GLenum format, int width, int height) {
    return {label, {.target = GL_TEXTURE_2D, .format = format, .width = width, .height = height}};
}

gl::Texture makeSampled(std::string_view label, GLenum format, int width, int height, int samples) {
    return {
        label,
        {.target = GL_TEXTURE_2D_MULTISAMPLE, .format = format, .width = width, .height = height, .samples = samples}};
}

constexpr GLenum kColourFormat = GL_SRGB8_ALPHA8;
constexpr GLenum kDepthFormat = GL_DEPTH_COMPONENT32F;

} // namespace

PictureTarget::PictureTarget(int width, int height, int samples)
    : samples_(offeredSamples(samples)),
      colour_(makePlain("picture colour", kColourFormat, width, height)),
      plain_("picture"),
      sampled_("multisampled picture") {
    plain_.attach(GL_COLOR_ATTACHMENT0, colour_);
    if (samples_ == 1) {
        depth_ = makePlain("picture depth", kDepthFormat, width, height);
        plain_.attach(GL_DEPTH_ATTACHMENT, depth_);
        plain_.requireComplete();
        return;
    }
    depth_ = makeSampled("picture depth", kDepthFormat, width, height, samples_);
    sampledColour_ = makeSampled("multisampled picture colour", kColourFormat, width, height, samples_);
    sampled_.attach(GL_COLOR_ATTACHMENT0, sampledColour_);
    sampled_.attach(GL_DEPTH_ATTACHMENT, depth_);
    plain_.requireComplete();
    sampled_.requireComplete();
}

RenderTarget PictureTarget::target() const {
    return {.framebuffer = samples_ > 1 ? sampled_.name() : plain_.name(),
            .viewport = {0, 0, width(), height()},
            .encodesSrgb = true};
}

const gl::Texture& PictureTarget::resolve() const {
    if (samples_ > 1)
        glBlitNamedFramebuffer(sampled_.name(), plain_.name(), 0, 0, width(), height(), 0, 0, width(), height(),
                               GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return colour_;
}

Image PictureTarget::read() const {
    resolve();
    return gl::readPixels(plain_.name(), width(), height());
}

} // namespace meltpool
