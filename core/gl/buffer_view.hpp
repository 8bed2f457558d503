// A buffer texture: a buffer that shaders read as texels.
#pragma once

#include "core/gl/buffer.hpp"

namespace meltpool::gl {

class BufferView {
  public:
    BufferView() = default;

    /// Makes all of `buffer`, which must outlive it, readable as texels of the sized `format` (GL_RGBA32F, ...). Throws
    /// RuntimeFault if the driver's buffer textures are too small for it.
    BufferView(std::string_view label, const Buffer& buffer, GLenum format, size_t texelBytes);

    void bind(GLuint unit) const { glBindTextureUnit(unit, handle_.name()); }

  private:
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
    Handle<destroy> handle_;
};

} // namespace meltpool::gl
