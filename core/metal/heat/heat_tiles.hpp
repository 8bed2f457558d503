// The parts of the metal that take part in a step of heat: tiles, rows of cells, particles off the lattice.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/program.hpp"
#include "core/gl/state_archive.hpp"
#include "shaders/shared/heat.h"

namespace meltpool {

/// The list of the slots of all living metal off the lattice (liquid, solid that fell or was fed) except held metal,
/// for passes that run over it. `slots` holds one uint each from entry `first` on, in no particular order. Their number
/// is a uint at byte `count` of `control` and stays on the GPU. Bind `control` as GL_DISPATCH_INDIRECT_BUFFER to
/// dispatch groups of GROUP_SIZE over the list from byte `dispatch`. After HeatSolver::step() the list includes the
/// metal that melted in it. The next step adds particles from MetalState::add() and solid that came free. A slot stays
/// in the list for good: a pass over it skips those without PHASE_ALIVE.
struct OffLatticeList {
    const gl::Buffer& slots;
    size_t first;
    const gl::Buffer& control; ///< HeatControl
    size_t count;              ///< byte of the number of entries in `control`
    size_t dispatch;           ///< byte of the indirect dispatch arguments in `control`
};

/// Lists tiles and rows on the GPU, as HeatControl describes them, and lets idle tiles sleep. The sizes of the lists
/// stay there: the passes over them are dispatched indirectly.
class HeatTiles {
  public:
    /// For a lattice of `tiles` and a state of `slots`. `defines`: of the passes of heat.
    HeatTiles(gl::ShaderLibrary& shaders, const gl::Defines& defines, size_t tiles, size_t slots);

    /// Adapts to a state of another capacity. Throws RuntimeFault if the driver has no memory.
    void setSlots(size_t slots);
    /// Clears the data that the passes hold between steps; forget() empties the lists.
    void clear();
    /// Empties the lists of slots off the lattice and of tiles with metal, and the record of the slots' cells.
    void forget();

    /// Binds the tile data that the passes of heat read, and the sizes of indirect dispatches.
    void bind() const;
    /// Binds the record of the slots' cells. Lists of rows and sums of sources have this binding in other passes.
    void bindKnownCells() const;

    /// Adds the slots from `first` to before `last` that hold metal off the lattice. The list already holds the metal
    /// that heat itself took off the lattice.
    void listOffLattice(size_t first, size_t last) const;
    /// Lists the tiles that take part in this step, and the rows of plain ones.
    void listTiles();
    /// Lists the rows of mixed tiles that hold metal; expects the temperatures of cells.
    void listMixedRows() const;

    OffLatticeList offLattice() const;
    /// Number of tiles that took part in the step of this number. Waits for the GPU.
    unsigned readActive(int stepNumber) const;

    void transfer(gl::StateArchive& archive);
    size_t bytes() const; ///< GPU memory

  private:
    size_t count_; ///< tiles of the lattice
    const gl::Program &listOffLattice_, &listTiles_, &listRows_;
    gl::Buffer tiles_, stamps_, lists_, listedRows_, control_, knownCells_;
    gl::BufferView tileTexels_, stampTexels_, listTexels_, listedRowTexels_;
};

} // namespace meltpool
