// The workshop: background and mirror image of the metal, painted once by shaders.
#pragma once

#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"

#include <filesystem>

namespace meltpool {

class Environment {
  public:
    /// Paints the room and its mirror images in rough surfaces. `kept`: folder in which they are stored for the next
    /// start, which then shows identical bits and paints nothing, as long as shaders and driver do not change; empty:
    /// not stored. `faceSize`: pixels along a cube face, a power of two.
    explicit Environment(gl::ShaderLibrary& shaders, const std::filesystem::path& kept = {}, int faceSize = 512);

    /// Binds the environment to SHARP_UNIT and ROUGH_UNIT, encoded as shaders/render/environment.glsl reads it.
    void bind() const;

    const gl::Texture& texture() const { return map_; }

  private:
    static void destroySampler(GLuint name) { glDeleteSamplers(1, &name); }

    gl::Texture map_;
    gl::Handle<destroySampler> levelZero_;
};

} // namespace meltpool
