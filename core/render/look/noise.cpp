#include "core/render/look/noise.hpp"

#include <cstdint>
#include <vector>

namespace meltpool {

namespace {

constexpr int kSize = 32;

/// Returns the PCG output permutation of the index (O'Neill 2014): needs no state.
std::uint8_t randomByte(std::uint32_t index) {
    const std::uint32_t state = index * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return static_cast<std::uint8_t>(((word >> 22u) ^ word) >> 8u);
}

} // namespace

gl::Texture makeNoiseTexture() {
    std::vector<std::uint8_t> values(4 * kSize * kSize * kSize);
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = randomByte(static_cast<std::uint32_t>(i));
    gl::Texture texture("noise",
                        {.target = GL_TEXTURE_3D, .format = GL_RGBA8, .width = kSize, .height = kSize, .depth = kSize});
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage3D(texture.name(), 0, 0, 0, 0, kSize, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, values.data());
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTextureParameteri(texture.name(), axis, GL_REPEAT);
    return texture;
}

} // namespace meltpool
