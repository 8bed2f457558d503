#include "core/gl/texture.hpp"

#include "core/base/error.hpp"

#include <algorithm>

namespace meltpool::gl {

Texture::Texture(std::string_view label, const Shape& s) : shape_(s) {
    GLuint name = 0;
    glCreateTextures(s.target, 1, &name);
    handle_ = Handle<destroy>(name);
    labelObject(GL_TEXTURE, name, label);
    switch (s.target) {
    case GL_TEXTURE_3D:
    case GL_TEXTURE_2D_ARRAY:
        glTextureStorage3D(name, s.levels, s.format, s.width, s.height, s.depth);
        break;
    case GL_TEXTURE_2D_MULTISAMPLE:
        glTextureStorage2DMultisample(name, s.samples, s.format, s.width, s.height, GL_TRUE);
        return;
    case GL_TEXTURE_2D_MULTISAMPLE_ARRAY:
        glTextureStorage3DMultisample(name, s.samples, s.format, s.width, s.height, s.depth, GL_TRUE);
        return;
    default:
        glTextureStorage2D(name, s.levels, s.format, s.width, s.height);
    }
    setSampling(true);
}

void Texture::setSampling(bool linear) const {
    const GLint magnify = linear ? GL_LINEAR : GL_NEAREST;
    const GLint minify = linear && shape_.levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : magnify;
    glTextureParameteri(name(), GL_TEXTURE_MIN_FILTER, minify);
    glTextureParameteri(name(), GL_TEXTURE_MAG_FILTER, magnify);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTextureParameteri(name(), axis, GL_CLAMP_TO_EDGE);
}

Framebuffer::Framebuffer(std::string_view label) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    handle_ = Handle<destroy>(name);
    labelObject(GL_FRAMEBUFFER, name, label);
}

void Framebuffer::attach(GLenum attachment, const Texture& texture, int level) const {
    glNamedFramebufferTexture(name(), attachment, texture.name(), level);
}

void Framebuffer::attachLayer(GLenum attachment, const Texture& texture, int layer, int level) const {
    glNamedFramebufferTextureLayer(name(), attachment, texture.name(), level, layer);
}

void Framebuffer::requireComplete() const {
    const GLenum status = glCheckNamedFramebufferStatus(name(), GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw RuntimeFault("the graphics driver cannot draw into this frame buffer (status " + std::to_string(status) +
                           ")");
}

VertexArray::VertexArray(std::string_view label) {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    handle_ = Handle<destroy>(name);
    labelObject(GL_VERTEX_ARRAY, name, label);
}

Image readPixels(GLuint framebuffer, int width, int height) {
    Image image{width, height, std::vector<std::uint8_t>(static_cast<size_t>(width) * static_cast<size_t>(height) * 3)};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
    const auto stride = static_cast<std::ptrdiff_t>(width) * 3;
    for (std::ptrdiff_t top = 0, bottom = height - 1; top < bottom; ++top, --bottom)
        std::swap_ranges(image.rgb.begin() + top * stride, image.rgb.begin() + (top + 1) * stride,
                         image.rgb.begin() + bottom * stride);
    return image;
}

} // namespace meltpool::gl
