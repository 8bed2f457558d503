// Conduction between cells, loss through the surface and melting: temperatures of cells and passes that advance them.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/program.hpp"
#include "core/gl/state_archive.hpp"
#include "core/metal/material/heat_table.hpp"
#include "shaders/shared/heat.h"

namespace meltpool {

/// Joules since the start, from the ledger.
struct HeatBalance {
    double gained = 0; ///< gain from sources and held walls
    double lost = 0;   ///< through the surface
};

/// Distributes the temperature of metal off the lattice over the surrounding cells; the cells exchange heat with their
/// neighbours; the power into each cell goes to its metal. The functions are the passes of a step in order; each
/// expects the lists that HeatTiles makes for it.
class Conduction {
  public:
    /// For a lattice of `cells` and a state of `slots`. `defines`: of the passes of heat. `ledger`: books every joule.
    Conduction(gl::ShaderLibrary& shaders, const gl::Defines& defines, size_t cells, size_t slots, bool ledger);

    /// Uploads samples of a material's table, and writes their places into the block of a step.
    void setTable(const HeatTable& table, HeatBlock& block);
    /// Adapts to a state of another capacity. Throws RuntimeFault if the driver has no memory.
    void setSlots(size_t slots);
    /// Empties cells and ledger.
    void clear();

    /// Binds cells, table and ledger.
    void bind() const;

    /// Adds the metal off the lattice to the sums of its cells.
    void depositOffLattice() const;
    /// Computes the temperature of each cell from the sums.
    void averageCells() const;
    /// Computes the power into each cell of mixed tiles, from neighbours and sources.
    void conductMixedTiles() const;
    void advanceOffLattice() const;
    /// Advances the lattice; metal that melts here is off the lattice from the next step on.
    void advanceLattice() const;

    /// The balance; zeros without a ledger. Waits for the GPU.
    HeatBalance readBalance() const;

    void transfer(gl::StateArchive& archive);
    size_t bytes() const; ///< GPU memory

  private:
    size_t cells_; ///< cells of the lattice
    bool hasLedger_;
    const gl::Program &deposit_, &averageCells_, &conductUnreached_, &conductReached_, &advanceOffLattice_,
        &conductLattice_, &advanceMixed_;
    gl::Buffer table_, cellTheta_, cellWeight_, cellSums_, cellRanges_, ledger_;
    gl::BufferView tableTexels_, thetaTexels_, weightTexels_, thetaRowTexels_;
};

} // namespace meltpool
