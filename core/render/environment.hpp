// The workshop that is seen behind the metal and mirrored by it, painted once by our own shaders.
#pragma once

#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"

namespace meltpool {

class Environment {
  public:
    /// Paints the room and what rough surfaces mirror of it. `faceSize`: pixels of a cube face, a power of two.
    explicit Environment(gl::ShaderLibrary& shaders, int faceSize = 512);

    /// The room as it is; one level, stored as decodeEnvironment() in shaders/render/environment.glsl reads it.
    const gl::Texture& sharp() const { return sharp_; }
    /// The room as rough surfaces mirror it; level i holds roughness (i + 1) / ROUGH_LEVELS.
    const gl::Texture& rough() const { return rough_; }

  private:
    gl::Texture sharp_;
    gl::Texture rough_;
};

} // namespace meltpool
