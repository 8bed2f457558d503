// The physical metal as a Trainer sees it: a workpiece of some material under a welding process.
#pragma once

#include "core/training/trainer/metal_model.hpp"
#include "core/weld/process/weld.hpp"
#include "core/weld/workpiece/rolled_faces.hpp"

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
    /// The torch's solids in it are lent until the next call.
    SceneView scene(const TorchSample& torch) const override;
    std::optional<WeldSection> section(std::optional<double> place) const override;
    std::optional<WeldMeasures> measureWeld(std::optional<FaceStretch> seam) const override;
    void prepare(Surface& surface) const override;
    MetalStatistics statistics() override { return weld_.metal().statistics(); }
    void requestStatistics() override { weld_.metal().requestStatistics(); }
    std::optional<MetalStatistics> pollStatistics() override { return weld_.metal().pollStatistics(); }
    std::optional<MetalStatistics> awaitStatistics() override { return weld_.metal().awaitStatistics(); }
    void transfer(gl::StateArchive& archive) override { weld_.transfer(archive); }
    void fold() override { weld_.fold(); }
    std::uint64_t stateHash() const override { return weld_.metal().stateHash(); }
    size_t bytes() const override { return weld_.bytes(); }

    const PhysicalMetal& metal() const { return weld_.metal(); }
    const Workpiece& workpiece() const { return workpiece_; }

  private:
    void furnish();

    Material material_;
    Workpiece workpiece_;
    RolledFaces rolled_;
    WeldKind kind_;
    std::optional<double> pipeRadius_; ///< m, outside
    ProcessSettings process_;
    Weld weld_;
    float overTable_;                        ///< m, see Fixture
    std::vector<Solid> furniture_;           ///< table, machine and what holds the workpiece
    size_t holders_ = 0;                     ///< how many of its last hold the workpiece
    glm::mat4 roomToWorld_{1.0F};            ///< of the workshop
    glm::vec3 cableEnd_{0.0F};               ///< of the torch, in the workpiece's frame
    mutable std::vector<Solid> torchSolids_; ///< those that the last scene() lends
    mutable std::vector<Solid> fittings_;    ///< the same
};

} // namespace meltpool
