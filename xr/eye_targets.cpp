// Makes the multisampled picture of both eyes and its resolved copy.
#include "xr/eye_targets.hpp"

#include <algorithm>

namespace meltpool::xr {

namespace {

int usableSamples(int wanted) {
    GLint colour = 1, depth = 1;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &colour);
    glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depth);
    return std::clamp(wanted, 1, std::max(1, std::min(colour, depth)));
}

gl::Texture picture(const char* label, GLenum format, int width, int height, int samples) {
    const GLenum target = samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    return gl::Texture(label, {target, format, width, height, 1, 1, samples});
}

} // namespace

EyeTargets::EyeTargets(GLenum colour, GLenum depth, int width, int height, int samples)
    : width_(width),
      height_(height),
      samples_(usableSamples(samples)),
      colour_(picture("eyes colour", colour, 2 * width, height, samples_)),
      depth_(picture("eyes depth", depth, 2 * width, height, samples_)),
      finishedColour_(picture("finished eyes colour", colour, 2 * width, height, 1)),
      finishedDepth_(picture("finished eyes depth", depth, 2 * width, height, 1)),
      drawn_("eyes"),
      finished_("finished eyes") {
    drawn_.attach(GL_COLOR_ATTACHMENT0, colour_);
    drawn_.attach(GL_DEPTH_ATTACHMENT, depth_);
    drawn_.requireComplete();
    finished_.attach(GL_COLOR_ATTACHMENT0, finishedColour_);
    finished_.attach(GL_DEPTH_ATTACHMENT, finishedDepth_);
    finished_.requireComplete();
}

void EyeTargets::resolve() const {
    // With GL_FRAMEBUFFER_SRGB the samples are averaged as light, not as encoded values.
    glEnable(GL_FRAMEBUFFER_SRGB);
    for (const GLbitfield what : {GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT})
        glBlitNamedFramebuffer(framebuffer(), resolved(), 0, 0, 2 * width_, height_, 0, 0, 2 * width_, height_, what,
                               GL_NEAREST);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

} // namespace meltpool::xr
