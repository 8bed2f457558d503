// Renderer of a scene as one or several views.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/render/look/look.hpp"
#include "core/render/scene.hpp"
#include "core/render/view.hpp"
#include "core/render/view_submission.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace meltpool {

class Renderer {
  public:
    /// Loads the programs and paints the environment. `kept`: folder in which the latter is stored for the next start,
    /// see Environment. Throws InputError when a shader is missing or wrong.
    explicit Renderer(gl::ShaderLibrary& shaders, const std::filesystem::path& kept = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Chooses the way in which draw() submits several views, `wanted` or the best, and loads the programs for it. If
    /// the driver does not support it, the next simpler way is chosen. Costs nothing when nothing changes. Without a
    /// call draw() chooses the best when it first needs it.
    const SubmissionChoice& submitBy(std::optional<ViewSubmission> wanted);

    /// Clears the target's viewport and draws the scene for each view, side by side in equal columns. Leaves depth
    /// test, scissor test, blending and culling off and the target's frame buffer bound. `profiler` may be null. Throws
    /// RuntimeFault for no view or more than kMostViews.
    void draw(const SceneView& scene, const LookParameters& look, std::span<const View> views,
              const RenderTarget& target, gl::Profiler* profiler);

    /// Draws markers over a target as the first view of the last draw() sees them, whatever is in front of them. The
    /// target has that view's shape; its size may be another one. Call it right after draw().
    void drawOver(std::span<const Marker> markers, const RenderTarget& target);

    /// Returns the mirrored surroundings of the metal and the sky, see Environment.
    const gl::Texture& environment() const;

    static constexpr size_t kMostViews = 4;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace meltpool
