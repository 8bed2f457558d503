// A metal in another context than the calling thread's: its steps wait for no picture, and surface and pictures are
// made of copies while it makes them.
#pragma once

#include "core/gl/other_context.hpp"
#include "core/metal/state/particle_mirror.hpp"
#include "core/training/trainer/metal_model.hpp"

#include <optional>

namespace meltpool {

/// Each function may be called on the other context's thread or, while nothing is under way there, on the thread that
/// made this. particles() and scene() show buffers of the calling thread's context: on the latter copies, made anew by
/// the first call after the metal changed, which stay as they are while further steps are made.
class MetalElsewhere : public MetalModel {
  public:
    /// `there` must outlive the metal and be of a driver of gl::dispatchesEndAtOnce(). Throws what makeMetalModel()
    /// throws.
    MetalElsewhere(gl::OtherContext& there, const Lesson& lesson);
    ~MetalElsewhere() override;

    void reset() override;
    void apply(const Lesson& lesson) override;
    void step(const TorchSample& torch, gl::Profiler* profiler) override;
    double timeStep() const override { return metal_->timeStep(); }
    ParticleView particles() const override;
    float unit() const override { return metal_->unit(); }
    std::optional<float> spacing() const override { return metal_->spacing(); }
    float liquidShare(float temperature) const override { return metal_->liquidShare(temperature); }
    ArcState arc(const SurfaceDistance& surface) const override { return metal_->arc(surface); }
    float touchRadius() const override { return metal_->touchRadius(); }
    float burntOff() const override { return metal_->burntOff(); }
    bool takesRod() const override { return metal_->takesRod(); }
    WireAccount wire() const override { return metal_->wire(); }
    SceneView scene(const TorchSample& torch) const override;
    std::optional<WeldSection> section(std::optional<double> place) const override;
    std::optional<WeldMeasures> measureWeld(std::optional<FaceStretch> seam) const override;
    void prepare(Surface& surface) const override { metal_->prepare(surface); }
    MetalStatistics statistics() override;
    void requestStatistics() override;
    std::optional<MetalStatistics> pollStatistics() override;
    std::optional<MetalStatistics> awaitStatistics() override;
    void transfer(gl::StateArchive& archive) override;
    void fold() override;
    std::uint64_t stateHash() const override;
    /// With the copies.
    size_t bytes() const override { return metal_->bytes() + mirror_.bytes(); }

  private:
    template <class Work>
    auto run(const Work& work) const;
    void stepTimed(const TorchSample& torch);

    gl::OtherContext& there_;
    std::unique_ptr<MetalModel> metal_;
    std::optional<gl::Profiler> times_; ///< of the other context
    mutable ParticleMirror mirror_;
    mutable bool changed_ = true; ///< since the mirror was made
};

} // namespace meltpool
