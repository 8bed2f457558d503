// Textures, frame buffers and vertex arrays.
#pragma once

#include "core/base/image.hpp"
#include "core/gl/handle.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace meltpool::gl {

/// An immutable-size texture: 2D, 2D array, 3D, cube map or multisampled 2D.
class Texture {
  public:
    struct Shape {
        GLenum target = GL_TEXTURE_2D; ///< GL_TEXTURE_2D, _2D_ARRAY, _3D, _CUBE_MAP, _2D_MULTISAMPLE(_ARRAY)
        GLenum format = GL_RGBA8;      ///< sized internal format
        int width = 1;
        int height = 1;
        int depth = 1;   ///< layers or slices
        int levels = 1;  ///< mipmaps
        int samples = 1; ///< sample count of multisampled targets
    };

    Texture() = default;
    Texture(std::string_view label, const Shape& shape);

    GLuint name() const { return handle_.name(); }
    const Shape& shape() const { return shape_; }
    explicit operator bool() const { return static_cast<bool>(handle_); }

    void bind(GLuint unit) const { glBindTextureUnit(unit, name()); }
    /// Binds the whole texture (all layers) of a level for image loads and stores.
    void bindImage(GLuint unit, GLenum access, GLenum format, int level = 0) const {
        glBindImageTexture(unit, name(), level, GL_TRUE, 0, access, format);
    }
    /// `linear` filtering (with mipmaps where there are levels) or nearest; coordinates clamped to the edge.
    void setSampling(bool linear) const;

  private:
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
    Handle<destroy> handle_;
    Shape shape_;
};

class Framebuffer {
  public:
    explicit Framebuffer(std::string_view label);

    GLuint name() const { return handle_.name(); }
    void attach(GLenum attachment, const Texture& texture, int level = 0) const;
    void attachLayer(GLenum attachment, const Texture& texture, int layer, int level = 0) const;
    /// Throws RuntimeFault with the status if the driver cannot draw into it.
    void requireComplete() const;

  private:
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
    Handle<destroy> handle_;
};

class VertexArray {
  public:
    explicit VertexArray(std::string_view label);
    GLuint name() const { return handle_.name(); }
    void bind() const { glBindVertexArray(name()); }

  private:
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
    Handle<destroy> handle_;
};

/// The frame buffer's colour (0 = the default one) as a picture, top row first. Waits for the GPU.
Image readPixels(GLuint framebuffer, int width, int height);

} // namespace meltpool::gl
