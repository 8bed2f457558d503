#include "core/gl/buffer_view.hpp"

#include "core/base/error.hpp"

namespace meltpool::gl {

BufferView::BufferView(std::string_view label, const Buffer& buffer, GLenum format, size_t texelBytes) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (buffer.bytes() / texelBytes > static_cast<size_t>(most))
        throw RuntimeFault("the graphics driver's buffer textures hold " + std::to_string(most) +
                           " texels, too few for '" + std::string(label) + "'; use fewer particles");
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &name);
    handle_ = Handle<destroy>(name);
    labelObject(GL_TEXTURE, name, label);
    glTextureBuffer(name, format, buffer.name());
}

} // namespace meltpool::gl
