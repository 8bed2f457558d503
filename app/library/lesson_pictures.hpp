// The lessons' pictures as textures of the home page.
#pragma once

#include "core/gl/texture.hpp"

#include <filesystem>
#include <map>

namespace meltpool {

class LessonPictures {
  public:
    /// Texture of a picture, loaded on first use; 0 if there is none or it cannot be read. Its colours are
    /// sRGB-encoded, as Dear ImGui draws them. Needs a current OpenGL context.
    GLuint texture(const std::filesystem::path& file);

  private:
    std::map<std::filesystem::path, gl::Texture> textures_;
};

} // namespace meltpool
