// Adapts the physical metal to the Trainer: a workpiece of some material under a welding process.
#pragma once

#include "core/training/trainer/metal_model.hpp"
#include "core/weld/process/weld.hpp"

namespace meltpool {

class WeldModel : public MetalModel {
  public:
    WeldModel(gl::ShaderLibrary& shaders, const Lesson& lesson);

    void reset() override;
    void apply(const Lesson& lesson) override;
    void step(const TorchSample& torch, gl::Profiler* profiler) override;
    double timeStep() const override { return weld_.timeStep(); }
    ParticleView particles() const override { return weld_.metal().particles(); }
    float unit() const override { return 1; }
    std::optional<float> spacing() const override { return workpiece_.lattice.spacing; }
    float liquidShare(float temperature) const override;
    ArcState arc(const SurfaceDistance&) const override { return weld_.arc(); }
    float touchRadius() const override { return weld_.process().touchRadius(); }
    float burntOff() const override { return weld_.process().burntOff(); }
    bool takesRod() const override { return weld_.process().takesRod(); }
    WireAccount wire() const override { return weld_.process().wire(); }
    std::unique_ptr<MetalScene> makeScene() const override;
    std::optional<WeldSection> section(std::optional<double> place) const override;
    std::optional<WeldMeasures> measureWeld(const StationSettings& stations) const override;
    void prepare(Surface& surface) const override;
    MetalStatistics statistics() override { return weld_.metal().statistics(); }
    void requestStatistics() override { weld_.metal().requestStatistics(); }
    std::optional<MetalStatistics> pollStatistics() override { return weld_.metal().pollStatistics(); }
    std::optional<MetalStatistics> awaitStatistics() override { return weld_.metal().awaitStatistics(); }
    void transfer(gl::StateArchive& archive) override { weld_.transfer(archive); }
    void xorOutDerivedState() override { weld_.xorOutDerivedState(); }
    std::uint64_t stateHash() const override { return weld_.metal().stateHash(); }
    size_t bytes() const override { return weld_.bytes(); }

    const PhysicalMetal& metal() const { return weld_.metal(); }
    const Workpiece& workpiece() const { return workpiece_; }

  private:
    Material material_;
    WorkpieceParameters parameters_; ///< values that the workpiece was made with
    Workpiece workpiece_;
    WeldKind kind_;
    std::optional<double> pipeRadius_; ///< outer radius, m
    ProcessSettings process_;
    Weld weld_;
};

} // namespace meltpool
