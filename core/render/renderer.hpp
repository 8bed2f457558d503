// Draws a scene as one or several views.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/render/look/look.hpp"
#include "core/render/scene.hpp"
#include "core/render/view/view.hpp"
#include "core/render/view/view_submission.hpp"

#include <memory>
#include <optional>
#include <span>

namespace meltpool {

class Renderer {
  public:
    /// Loads the programs and paints the environment. Throws InputError when a shader is missing or wrong.
    explicit Renderer(gl::ShaderLibrary& shaders);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Chooses how several views are submitted from now on, `wanted` or the best, and loads the programs for it. Where
    /// the driver cannot, the next plainer way is taken. Cheap where nothing changes. Without a call draw() takes the
    /// best when it has to.
    const SubmissionChoice& submitBy(std::optional<ViewSubmission> wanted);

    /// Clears the target's viewport and draws the scene for each view, side by side in equal columns. Leaves depth
    /// test, scissor test, blending and culling off and the target's frame buffer bound. `profiler` may be null. At
    /// most kMostViews.
    void draw(const SceneView& scene, const LookParameters& look, std::span<const View> views,
              const RenderTarget& target, gl::Profiler* profiler);

    static constexpr size_t kMostViews = 4;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace meltpool
