// The workshop that is seen behind the metal and mirrored by it, painted once by our own shaders.
#pragma once

#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"

namespace meltpool {

class Environment {
  public:
    /// Paints the room and what rough surfaces mirror of it. `faceSize`: pixels of a cube face, a power of two.
    explicit Environment(gl::ShaderLibrary& shaders, int faceSize = 512);

    /// Binds the room to SHARP_UNIT and ROUGH_UNIT, stored as shaders/render/environment.glsl reads it.
    void bind() const;

    const gl::Texture& texture() const { return room_; }

  private:
    static void destroySampler(GLuint name) { glDeleteSamplers(1, &name); }

    gl::Texture room_;
    gl::Handle<destroySampler> levelZero_;
};

} // namespace meltpool
