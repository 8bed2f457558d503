// Painter of the effects about an arc: sparks as quads along their way, the smoke that the arc lights, and puffs of it
// that rise.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/texture.hpp"
#include "core/render/effects/spark.hpp"
#include "core/render/look/look.hpp"
#include "core/render/scene.hpp"
#include "core/render/toned_program.hpp"

#include <array>

namespace meltpool {

class EffectsPainter {
  public:
    explicit EffectsPainter(gl::ShaderLibrary& shaders);

    /// Loads the programs' forms for one way of submission. Throws InputError when the driver does not compile one.
    void load(ViewSubmission submission) {
        sparks_.load(submission);
        haze_.load(submission);
        fume_.load(submission);
        afterImage_.load(submission);
    }

    /// Copies the scene's sparks and puffs of smoke to the GPU for the draws to come, as far as the look shows them:
    /// not for metal that is cut or shown in colours of its temperature, and not at low detail.
    void upload(const SceneView& scene, const LookParameters& look);

    /// Draws the sparks. Expects the frame's uniform blocks bound, blending on and the depth after all other things.
    void drawSparks(const ViewBatch& views, const RenderTarget& target) const;
    /// Draws the puffs of smoke, before the sparks that fly in front of them. Expects the state of drawSparks().
    void drawFume(const ViewBatch& views, const RenderTarget& target) const;
    /// Draws the smoke over all that is behind it.
    void drawHaze(const ViewBatch& views, const RenderTarget& target) const;

    /// Draws the after-image of an arc in the eye, over everything.
    void drawAfterImage(const AfterImage& image, const ViewBatch& views, const RenderTarget& target) const;

    bool shows() const { return count_ > 0 || scattering_ > 0 || puffs_ > 0; }

  private:
    void uploadSparks(const SceneView& scene, const LookParameters& look);
    void uploadFume(const SceneView& scene, const LookParameters& look);

    TonedProgram sparks_, haze_, fume_, afterImage_;
    gl::VertexArray empty_;
    /// Buffers that frames use in turn, so that writing one does not wait for frames that the GPU still draws.
    std::array<gl::Buffer, 3> buffers_, puffBuffers_;
    size_t current_ = 0;
    size_t count_ = 0;
    float scattering_ = 0;
    size_t puffs_ = 0;
    glm::vec3 pool_{0};
    float tableTop_ = 0; ///< world height of the table's top
};

} // namespace meltpool
