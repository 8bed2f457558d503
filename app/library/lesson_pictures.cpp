#include "app/library/lesson_pictures.hpp"

#include "core/base/error.hpp"
#include "core/base/image.hpp"

#include <algorithm>
#include <bit>

namespace meltpool {

namespace {

gl::Texture load(const std::filesystem::path& file) {
    const Image image = readPng(file);
    const auto longest = static_cast<unsigned>(std::max(image.width, image.height));
    gl::Texture texture(
        "lesson picture",
        {.width = image.width, .height = image.height, .levels = static_cast<int>(std::bit_width(longest))});
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1); // rows of three bytes a pixel
    glTextureSubImage2D(texture.name(), 0, 0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glGenerateTextureMipmap(texture.name());
    return texture;
}

} // namespace

GLuint LessonPictures::texture(const std::filesystem::path& file) {
    const auto known = textures_.find(file);
    if (known != textures_.end()) return known->second.name();
    gl::Texture texture;
    try {
        texture = load(file);
    } catch (const InputError&) {
        // The lesson is listed without its picture.
    }
    return textures_.emplace(file, std::move(texture)).first->second.name();
}

} // namespace meltpool
