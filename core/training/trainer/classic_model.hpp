// Adapts the classic metal to the Trainer: metres become box units, the trigger becomes the source's strength.
#pragma once

#include "core/metal/classic/classic_metal.hpp"
#include "core/training/trainer/metal_model.hpp"

namespace meltpool {

/// Length of one unit of the classic box, m: the solder cube of 40 mm has an edge of 1.
inline constexpr float kClassicUnit = 0.04f;

/// Place of the source for a torch tip (m, from the middle of the box), in box units; it never leaves the box.
glm::vec3 classicSourcePosition(const glm::vec3& tip);

class ClassicModel : public MetalModel {
  public:
    ClassicModel(gl::ShaderLibrary& shaders, const Lesson& lesson);

    void reset() override { metal_.reset(); }
    void apply(const Lesson& lesson) override;
    void step(const TorchSample& torch, gl::Profiler* profiler) override;
    double timeStep() const override { return static_cast<double>(metal_.parameters.timeStep); }
    ParticleView particles() const override { return metal_.particles(); }
    void prepare(Surface& surface) const override;
    float unit() const override { return kClassicUnit; }
    float liquidShare(float temperature) const override;
    /// A source that heats the more the nearer it is.
    ArcState arc(const SurfaceDistance& surface) const override;
    std::unique_ptr<MetalScene> makeScene() const override;
    MetalStatistics statistics() override { return metal_.statistics(); }
    void requestStatistics() override { metal_.requestStatistics(); }
    std::optional<MetalStatistics> pollStatistics() override { return metal_.pollStatistics(); }
    std::optional<MetalStatistics> awaitStatistics() override { return metal_.awaitStatistics(); }
    void transfer(gl::StateArchive& archive) override {
        archive.values(trigger_);
        metal_.transfer(archive);
    }
    std::uint64_t stateHash() const override { return metal_.stateHash(); }
    size_t bytes() const override { return metal_.bytes(); }

  private:
    ClassicMetal metal_;
    bool cold_ = false;
    float trigger_ = 0; ///< trigger of the last step
};

} // namespace meltpool
