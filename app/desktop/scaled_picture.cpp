#include "app/desktop/scaled_picture.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace meltpool {

ScaledPicture::ScaledPicture(gl::ShaderLibrary& shaders)
    : enlarge_(shaders.load({"render/screen.vert", "render/enlarge.frag"})), empty_("scaled picture") {}

RenderTarget ScaledPicture::begin(glm::ivec2 window, float share) {
    window_ = window;
    const glm::ivec2 size = glm::max(glm::ivec2(glm::round(glm::vec2(window) * share)), glm::ivec2(1));
    if (share >= 1) {
        buffers_.reset();
        size_ = {};
        return {0, {0, 0, window.x, window.y}};
    }
    if (!buffers_ || size != size_) {
        buffers_.reset(); // the next picture may need the memory
        buffers_ = std::make_unique<Buffers>();
        buffers_->colour = gl::Texture("scaled picture", {.width = size.x, .height = size.y});
        buffers_->depth =
            gl::Texture("scaled picture depth", {.format = GL_DEPTH_COMPONENT24, .width = size.x, .height = size.y});
        buffers_->framebuffer.attach(GL_COLOR_ATTACHMENT0, buffers_->colour);
        buffers_->framebuffer.attach(GL_DEPTH_ATTACHMENT, buffers_->depth);
        buffers_->framebuffer.requireComplete();
        size_ = size;
    }
    return {buffers_->framebuffer.name(), {0, 0, size.x, size.y}};
}

/// A shader enlarges the picture: if the processor draws, glBlitNamedFramebuffer() takes half as long again.
void ScaledPicture::end(GLuint window) const {
    glBindFramebuffer(GL_FRAMEBUFFER, window);
    if (!buffers_) return;
    for (const GLenum capability : {GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_BLEND, GL_FRAMEBUFFER_SRGB})
        glDisable(capability);
    glViewport(0, 0, window_.x, window_.y);
    buffers_->colour.bind(0);
    enlarge_.use();
    empty_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace meltpool
