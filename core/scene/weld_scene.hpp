// A weld's workshop: torch, cable, table, machine and holders of the workpiece, with the looks of the material.
#pragma once

#include "core/base/units.hpp"
#include "core/scene/metal_scene.hpp"
#include "core/weld/process/weld.hpp"
#include "core/weld/workpiece/rolled_faces.hpp"

#include <array>
#include <vector>

namespace meltpool {

/// The weld that a WeldScene shows. All of it must outlive the scene.
struct ShownWeld {
    const Weld& weld;
    const Workpiece& workpiece;
    const WorkpieceParameters& parameters; ///< parameters that the workpiece was made of
    const Material& material;
    const ProcessSettings& process; ///< read by each view(); other displays furnish the workshop again
};

class WeldScene : public MetalScene {
  public:
    /// Builds the table, the machine and the holders.
    explicit WeldScene(const ShownWeld& shown);

    SceneView view(const TorchSample& torch) override;
    void addHolders(std::vector<Solid>& solids, float overTable) const override;

  private:
    void furnish();
    void showTorch(SceneView& scene, const TorchSample& torch);

    ShownWeld shown_;
    RolledFaces rolled_;
    float overTable_;                        ///< m, see Fixture
    std::array<MachineDisplay, 2> displays_; ///< displays of the machine as it was furnished
    UnitSystem units_ = chosenUnits();       ///< units of those displays
    std::vector<Solid> furniture_;           ///< table, machine and holders of the workpiece
    size_t holders_ = 0;                     ///< number of its last solids that hold the workpiece
    glm::mat4 roomToWorld_{1.0F};            ///< transform of the workshop
    glm::vec3 cableEnd_{0.0F};               ///< end of the torch's cable, in the workpiece's frame
    std::vector<Solid> torchSolids_;         ///< lent by the last view()
    std::vector<Solid> fittings_;            ///< lent likewise
};

} // namespace meltpool
