#include "tests/render/look/patch.hpp"

#include "core/render/camera.hpp"
#include "shaders/shared/render.h"
#include "shaders/shared/surface.h"
#include "tests/support/gl_fixture.hpp"

#include <glm/vec4.hpp>

#include <array>
#include <cmath>

namespace meltpool::test {

using glm::vec3;

Patch::Patch(float temperature, float peak) {
    constexpr float kHalf = 0.02f; // small, so that its vertices' values hold for its middle
    std::array<SurfaceVertex, 4> corners{};
    for (size_t i = 0; i < 4; ++i)
        corners[i] = {{i == 1 || i == 2 ? kHalf : -kHalf, i > 1 ? kHalf : -kHalf, 0}, temperature, {0, 0, 1}, 0};
    const std::array<GLuint, 6> order{0, 1, 2, 0, 2, 3};
    const SurfaceDraw draw{6, 1, 0, 0, 0};
    const std::array<float, 4> peaks{peak, peak, peak, peak};
    vertices_ = gl::Buffer("patch vertices", std::span<const SurfaceVertex>(corners));
    indices_ = gl::Buffer("patch indices", std::span<const GLuint>(order));
    command_ = gl::Buffer("patch command", std::span<const SurfaceDraw>(&draw, 1));
    peaks_ = gl::Buffer("patch peaks", std::span<const float>(peaks));
}

SceneView Patch::scene(const MaterialLooks& looks) const {
    SceneView scene;
    scene.mesh = {&vertices_, &indices_, &command_, &peaks_};
    scene.temperature = {293.15f, 2500, true, kPatchSolidus, kPatchLiquidus};
    scene.looks = &looks;
    return scene;
}

Renderer& patchRenderer() {
    static Renderer only(shaders());
    return only;
}

LookParameters roomOnly(float ambient) {
    LookParameters look;
    look.showBox = look.showSky = look.showSource = false;
    look.ambient = ambient;
    look.diffuse = look.specular = 0;
    look.arcLight = 1;
    return look;
}

vec3 lightOf(Renderer& renderer, const SceneView& scene, const LookParameters& look, vec3 eye, vec3 target) {
    constexpr int kSize = 9; // odd, so that the middle pixel's centre is the picture's
    const gl::Texture colour("light", {.format = GL_RGBA32F, .width = kSize, .height = kSize});
    const gl::Texture depth("depth", {.format = GL_DEPTH_COMPONENT24, .width = kSize, .height = kSize});
    const gl::Framebuffer picture("light");
    picture.attach(GL_COLOR_ATTACHMENT0, colour);
    picture.attach(GL_DEPTH_ATTACHMENT, depth);
    const View view = FreeCamera(eye, target).view({}, 1);
    // A target with encoding expects light; this one stores it as numbers.
    const RenderTarget where{.framebuffer = picture.name(), .viewport = {0, 0, kSize, kSize}, .encodesSrgb = true};
    renderer.draw(scene, look, {&view, 1}, where, nullptr);
    glm::vec4 pixel(0);
    glBindFramebuffer(GL_FRAMEBUFFER, picture.name());
    glReadPixels(kSize / 2, kSize / 2, 1, 1, GL_RGBA, GL_FLOAT, &pixel);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return vec3(pixel);
}

std::vector<float> lightOfPixels(Renderer& renderer, const SceneView& scene, const LookParameters& look,
                                 const View& view, int size) {
    const gl::Texture colour("light", {.format = GL_RGBA32F, .width = size, .height = size});
    const gl::Texture depth("depth", {.format = GL_DEPTH_COMPONENT24, .width = size, .height = size});
    const gl::Framebuffer picture("light");
    picture.attach(GL_COLOR_ATTACHMENT0, colour);
    picture.attach(GL_DEPTH_ATTACHMENT, depth);
    // A target with encoding expects light; this one stores it as numbers.
    const RenderTarget where{.framebuffer = picture.name(), .viewport = {0, 0, size, size}, .encodesSrgb = true};
    renderer.draw(scene, look, {&view, 1}, where, nullptr);
    std::vector<glm::vec4> pixels(static_cast<size_t>(size) * static_cast<size_t>(size));
    glBindFramebuffer(GL_FRAMEBUFFER, picture.name());
    glReadPixels(0, 0, size, size, GL_RGBA, GL_FLOAT, pixels.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    std::vector<float> light;
    for (const glm::vec4& pixel : pixels)
        light.push_back(pixel.g);
    return light;
}

Renderer& evenlyLit(float light) {
    static Renderer only(shaders());
    static float painted = -1;
    if (light == painted) return only;
    painted = light;
    const auto stored = static_cast<GLfloat>(std::sqrt(double(light) / ENVIRONMENT_RANGE));
    const std::array<GLfloat, 4> colour{stored, stored, stored, 1};
    for (int level = 0; level < ENVIRONMENT_LEVELS; ++level)
        glClearTexImage(only.environment().name(), level, GL_RGBA, GL_FLOAT, colour.data());
    return only;
}

} // namespace meltpool::test
