// Heat in the metal on the GPU: conduction, surface loss and sources, in steps that follow the conduction limit.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/metal/heat/conduction.hpp"
#include "core/metal/heat/heat_source.hpp"
#include "core/metal/heat/heat_tiles.hpp"
#include "core/metal/heat/source_weights.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/dispatch.h"
#include "shaders/shared/heat.h"

#include <vector>

namespace meltpool {

/// The surroundings and the method.
struct HeatSettings {
    double ambient = 293.15;        ///< K
    glm::vec3 tableNormal{0, 1, 0}; ///< unit vector out of the welding table, against gravity
    double tableHeight = 0;         ///< m along the normal, height of the welding table that fallen metal rests on
    double tableConductance = 0;    ///< W/(m² K) from metal that rests on the table, at ambient temperature; 0: none
    double convection = 0;          ///< W/(m² K); 0 together with `radiation` false: insulated
    bool radiation = false;         ///< radiation with the material's emissivity at the liquidus
    bool evaporation = false;       ///< if the material has the data
    double stepShare = 0.15; ///< longest step as a share of dx²/alpha: 1/6 is the limit of stability of ragged metal,
                             ///< and near it the errors of space and time cancel
    double wakingKelvin = 0.03; ///< difference between neighbours below which a tile sleeps
    bool ledger = false;        ///< books every joule in and out, for the balance
    bool directedMixing = false; ///< setStirringLess() may be called
    bool meltedLeaves = false;  ///< melted particles leave the lattice (with flow) or stay on it (heat alone)
};

/// A step of heat in the metal: the participating parts (HeatTiles), the division of the sources' power
/// (SourceWeights), and the gain and loss of each cell (Conduction).
class HeatSolver {
  public:
    /// `state` must outlive the solver.
    HeatSolver(gl::ShaderLibrary& shaders, MetalState& state, const Material& material, const HeatSettings& settings);

    /// Returns to the initial state without allocating; call it after the state was reset and refilled.
    void reset();
    /// Reduces the liquid's conductivity along x, y and z by these shares of the table's value from the next step on,
    /// each from 0 to below 1; metal that is not wholly liquid is unchanged. Expects HeatSettings::directedMixing. A
    /// reset cancels it.
    void setStirringLess(glm::vec3 shares) { block_.stirringLess = shares; }

    /// Adapts to the state's new capacity. Throws RuntimeFault if the driver has no memory.
    void onCapacityChanged();

    /// Adapts to the state's new table.
    void onTableChanged();

    /// Longest step for temperatures up to `hottest` (K): stepShare dx²/alpha, in s.
    double longestStep(double hottest) const;

    /// Makes one step of `seconds`. Reads position, writes heat, phase, position.w; never waits. Throws RuntimeFault
    /// for more than HEAT_SOURCES sources.
    void step(double seconds, std::span<const HeatSource> sources, gl::Profiler* profiler = nullptr);

    /// Reads the whole lattice and wakes every tile. Call it after adding particles to the lattice or removing some.
    void refresh();

    OffLatticeList offLattice() const { return tiles_.offLattice(); }

    /// Tiles that took part in the last step. Waits for the GPU.
    unsigned readActiveTiles() const { return tiles_.readActive(block_.stepNumber); }
    HeatBalance readBalance() const { return conduction_.readBalance(); }

    /// Saves or restores all that the next step reads; transfer the state first.
    void transfer(gl::StateArchive& archive);
    /// Applies PhysicalMetal::xorOutDerivedState() to temperatures, peaks and Kirchhoff variables, which follow from
    /// the enthalpies.
    void xorOutDerivedState();

    size_t bytes() const; ///< GPU memory of the solver itself

  private:
    struct Texels {
        gl::BufferView view;
        GLuint unit;
    };

    void makeTexels();
    void begin();
    void prepareBlock();
    void writeBlock(double seconds, std::span<const HeatSource> sources);
    void bind() const;
    void listOffLattice();

    MetalState& state_;
    const Material material_;
    HeatSettings settings_;
    HeatBlock block_{};
    size_t searched_ = 0;      ///< slots searched for metal off the lattice
    unsigned regroupings_ = 0; ///< the state's regroupings and labellings when all slots were last searched
    double time_ = 0;          ///< s
    HeatTiles tiles_;
    SourceWeights sources_;
    Conduction conduction_;
    const gl::Program &refresh_, &xorOutDerived_;
    gl::Buffer blockBuffer_;
    std::vector<Texels> texels_; ///< views of the state's buffers
};

} // namespace meltpool
