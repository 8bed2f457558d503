#include "core/render/look/environment.hpp"

#include "core/base/hash.hpp"
#include "core/render/look/kept_picture.hpp"
#include "shaders/shared/render.h"

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

namespace {

constexpr int kFaces = 6;
constexpr int kTexelBytes = 4; // bytes of a GL_RGB10_A2 texel
/// Edition of the painting: raise it when this file paints the room differently, so that no program shows a stored
/// picture of a former edition.
constexpr std::uint64_t kEdition = 1;
const std::array<std::string, 2> kPaint{"render/screen.vert", "render/workshop.frag"};
const std::array<std::string, 2> kRoughen{"render/screen.vert", "render/roughen.frag"};

gl::Texture makeCube(std::string_view label, GLenum format, int size, int levels) {
    return {label, {.target = GL_TEXTURE_CUBE_MAP, .format = format, .width = size, .height = size, .levels = levels}};
}

int levelsOf(int size) {
    int levels = 1;
    for (; size > 1; size /= 2)
        ++levels;
    return levels;
}

/// Draws one triangle over each face of a level; the uniform at location 0 of `program` is the face's index.
void paintFaces(const gl::Program& program, const gl::Texture& cube, int level) {
    const gl::Framebuffer framebuffer("environment face");
    const gl::VertexArray none("environment face");
    const int size = cube.shape().width >> level;
    none.bind();
    program.use();
    glViewport(0, 0, size, size);
    for (int face = 0; face < kFaces; ++face) {
        framebuffer.attachLayer(GL_COLOR_ATTACHMENT0, cube, face, level);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glProgramUniform1i(program.name(), 0, face);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

gl::Texture paintWorkshop(gl::ShaderLibrary& shaders, int size) {
    gl::Texture light = makeCube("workshop light", GL_RGBA16F, size, levelsOf(size));
    const gl::Program& paint = shaders.load({kPaint.begin(), kPaint.end()});
    paint.set("texel", 2.0f / static_cast<float>(size));
    paint.set("rays", 2); // number of rays; workshop.frag places them for two
    paintFaces(paint, light, 0);
    glGenerateTextureMipmap(light.name());
    return light;
}

void paintMap(gl::ShaderLibrary& shaders, const gl::Texture& map) {
    const int size = map.shape().width;
    glBindSampler(SHARP_UNIT, 0); // the sampler of another environment may be bound there; it would hide the levels
    const gl::Texture light = paintWorkshop(shaders, size);
    const gl::Program& roughen = shaders.load({kRoughen.begin(), kRoughen.end()});
    light.bind(SHARP_UNIT);
    roughen.set("sourceSize", static_cast<float>(size));
    for (int level = 0; level < ENVIRONMENT_LEVELS; ++level) {
        roughen.set("roughness", std::pow(static_cast<float>(level) / (ENVIRONMENT_LEVELS - 1), 1.5f));
        paintFaces(roughen, map, level);
    }
}

size_t levelBytes(int size, int level) {
    const auto edge = static_cast<size_t>(size >> level);
    return kFaces * kTexelBytes * edge * edge;
}

size_t roomBytes(int size) {
    size_t sum = 0;
    for (int level = 0; level < ENVIRONMENT_LEVELS; ++level)
        sum += levelBytes(size, level);
    return sum;
}

/// Returns the key of all inputs of the painted room: the shaders' texts and the driver, whose last bits differ.
std::uint64_t keyOf(const gl::ShaderLibrary& shaders, int size) {
    std::uint64_t key = kEdition;
    const auto add = [&](const std::string& text) { key = hashOfBytes(std::as_bytes(std::span(text)), key); };
    for (const auto* files : {&kPaint, &kRoughen})
        for (const std::string& file : *files)
            add(gl::loadShaderSource(shaders.root(), file, {}).text);
    for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION})
        add(reinterpret_cast<const char*>(glGetString(name)));
    add(std::to_string(size));
    return key;
}

std::vector<std::byte> readMap(const gl::Texture& map) {
    const int size = map.shape().width;
    std::vector<std::byte> bytes(roomBytes(size));
    size_t at = 0;
    for (int level = 0; level < ENVIRONMENT_LEVELS; at += levelBytes(size, level++))
        glGetTextureImage(map.name(), level, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV,
                          static_cast<GLsizei>(levelBytes(size, level)), bytes.data() + at);
    return bytes;
}

void writeMap(const gl::Texture& map, std::span<const std::byte> bytes) {
    const int size = map.shape().width;
    size_t at = 0;
    for (int level = 0; level < ENVIRONMENT_LEVELS; at += levelBytes(size, level++))
        glTextureSubImage3D(map.name(), level, 0, 0, 0, size >> level, size >> level, kFaces, GL_RGBA,
                            GL_UNSIGNED_INT_2_10_10_10_REV, bytes.data() + at);
}

} // namespace

Environment::Environment(gl::ShaderLibrary& shaders, const std::filesystem::path& kept, int faceSize)
    : map_(makeCube("environment", GL_RGB10_A2, faceSize, ENVIRONMENT_LEVELS)) {
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    if (kept.empty()) {
        paintMap(shaders, map_);
    } else {
        const std::uint64_t key = keyOf(shaders, faceSize);
        const std::filesystem::path file = kept / "workshop.bin";
        if (const auto picture = keptPicture(file, key, roomBytes(faceSize))) {
            writeMap(map_, *picture);
        } else {
            paintMap(shaders, map_);
            keepPicture(file, key, readMap(map_));
        }
    }
    GLuint sampler = 0;
    glCreateSamplers(1, &sampler);
    levelZero_ = gl::Handle<destroySampler>(sampler);
    gl::labelObject(GL_SAMPLER, sampler, "environment without levels");
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

void Environment::bind() const {
    map_.bind(SHARP_UNIT);
    map_.bind(ROUGH_UNIT);
    glBindSampler(SHARP_UNIT, levelZero_.name());
}

} // namespace meltpool
