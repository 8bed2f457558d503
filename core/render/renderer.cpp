#include "core/render/renderer.hpp"

namespace meltpool {

struct Renderer::Parts {};

Renderer::Renderer(gl::ShaderLibrary&) : parts_(std::make_unique<Parts>()) {}

Renderer::~Renderer() = default;

void Renderer::draw(const SceneView&, const LookParameters& look, std::span<const View>, const RenderTarget& target,
                    gl::Profiler*) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(target.viewport.x, target.viewport.y, target.viewport.width, target.viewport.height);
    glClearColor(0.1f * look.exposure, 0.1f * look.exposure, 0.1f * look.exposure, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

} // namespace meltpool
