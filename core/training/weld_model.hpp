// The physical metal as a Trainer sees it: a workpiece of some material under a welding process.
#pragma once

#include "core/metal/physical_metal.hpp"
#include "core/training/metal_model.hpp"
#include "core/weld/process/process.hpp"
#include "core/weld/workpiece.hpp"

namespace meltpool {

class WeldModel : public MetalModel {
  public:
    WeldModel(gl::ShaderLibrary& shaders, const Lesson& lesson);

    void reset() override;
    void apply(const Lesson& lesson) override;
    void step(const TorchSample& torch, gl::Profiler* profiler) override;
    double timeStep() const override { return static_cast<double>(metal_.timeStep()); }
    ParticleView particles() const override { return metal_.particles(); }
    float unit() const override { return 1; }
    float liquidShare(float temperature) const override;
    TipGap gap() const override { return tipGap(process_.parameters); }
    /// The torch's solids in it are lent until the next call.
    SceneView scene(const TorchSample& torch) const override;
    std::optional<WeldSection> section(std::optional<double> place) const override;
    void prepare(Surface& surface) const override;
    MetalStatistics statistics() override { return metal_.statistics(); }
    void requestStatistics() override { metal_.requestStatistics(); }
    std::optional<MetalStatistics> pollStatistics() override { return metal_.pollStatistics(); }
    std::uint64_t stateHash() const override { return metal_.stateHash(); }
    size_t bytes() const override { return metal_.bytes(); }

    const PhysicalMetal& metal() const { return metal_; }

  private:
    Material material_;
    Workpiece workpiece_;
    PhysicalMetal metal_;
    WeldProcess process_;
    mutable std::vector<Solid> torchSolids_; ///< those that the last scene() lends
};

} // namespace meltpool
