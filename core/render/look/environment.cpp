#include "core/render/look/environment.hpp"

#include "shaders/shared/render.h"

#include <cmath>

namespace meltpool {

namespace {

constexpr int kFaces = 6;

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
    const gl::Program& paint = shaders.load({"render/screen.vert", "render/workshop.frag"});
    paint.set("texel", 2.0f / static_cast<float>(size));
    paint.set("rays", 2); // workshop.frag places them for two
    paintFaces(paint, light, 0);
    glGenerateTextureMipmap(light.name());
    return light;
}

} // namespace

Environment::Environment(gl::ShaderLibrary& shaders, int faceSize)
    : room_(makeCube("environment", GL_RGB10_A2, faceSize, ENVIRONMENT_LEVELS)) {
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glBindSampler(SHARP_UNIT, 0); // the sampler of another environment may be bound there; it would hide the levels
    const gl::Texture light = paintWorkshop(shaders, faceSize);
    const gl::Program& roughen = shaders.load({"render/screen.vert", "render/roughen.frag"});
    light.bind(SHARP_UNIT);
    roughen.set("sourceSize", static_cast<float>(faceSize));
    for (int level = 0; level < ENVIRONMENT_LEVELS; ++level) {
        roughen.set("roughness", std::pow(static_cast<float>(level) / (ENVIRONMENT_LEVELS - 1), 1.5f));
        paintFaces(roughen, room_, level);
    }
    GLuint sampler = 0;
    glCreateSamplers(1, &sampler);
    levelZero_ = gl::Handle<destroySampler>(sampler);
    gl::labelObject(GL_SAMPLER, sampler, "environment without levels");
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

void Environment::bind() const {
    room_.bind(SHARP_UNIT);
    room_.bind(ROUGH_UNIT);
    glBindSampler(SHARP_UNIT, levelZero_.name());
}

} // namespace meltpool
