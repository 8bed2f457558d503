// Draws a scene as one or several views.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/render/look.hpp"
#include "core/render/scene.hpp"
#include "core/render/view.hpp"

#include <memory>
#include <span>

namespace meltpool {

class Renderer {
  public:
    /// Loads the programs and paints the environment. Throws InputError when a shader is missing or wrong.
    explicit Renderer(gl::ShaderLibrary& shaders);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Clears the target's viewport and draws the scene once for each view, side by side in equal columns. Leaves depth
    /// test, blending and culling off and the target's frame buffer bound. `profiler` may be null. At most kMostViews.
    void draw(const SceneView& scene, const LookParameters& look, std::span<const View> views,
              const RenderTarget& target, gl::Profiler* profiler);

    /// Sizes of the zone whose peak temperature reached `peak` (K) in the section that was last drawn, model units;
    /// `level` is the height of the plate's surface along the section's upward axis. Waits for the GPU.
    SectionZone measureSection(double peak, double level) const;

    static constexpr size_t kMostViews = 4;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace meltpool
