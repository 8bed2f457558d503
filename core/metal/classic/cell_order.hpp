// Sorts the particles of the classic model by the cells of a uniform grid, so that neighbours are found in short
// ranges.
#pragma once

#include "core/gl/buffer_view.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"

namespace meltpool {

/// The grid over the box [-1, 1]³.
struct CellGrid {
    unsigned perAxis = 1;
    float cellsPerUnit = 0.5F; ///< 1 / edge of a cell
    unsigned cells() const { return perAxis * perAxis * perAxis; }
    bool operator==(const CellGrid&) const = default;

    /// A grid with the support radius as edge of its cells; larger cells if there would be more than 8 a particle.
    static CellGrid forRadius(float supportRadius, size_t particles);
};

/// A counting sort in five passes: count particles of cells, sum chunks of cells, start of each cell, particle numbers
/// by cell, copy of the state in order.
class CellOrder {
  public:
    CellOrder(gl::ShaderLibrary& library, size_t particles);

    /// Uses another grid and discards the counts.
    void setGrid(const CellGrid& grid);
    const CellGrid& grid() const { return grid_; }

    /// Makes the next sort() count the particles of the cells again: they have moved since.
    void discardCounts() { counted_ = false; }

    /// Binds its buffers for the passes that visit neighbours and count particles.
    void bind() const;

    /// Sorts the bound moved state into the bound sorted state. Counts first unless the pass that moved the particles
    /// counted them. Leaves the counts zero for the pass that moves the particles next.
    void sort(gl::Profiler* profiler);

    const gl::Buffer& cellStarts() const { return cellStarts_; }
    size_t bytes() const;

  private:
    void count(gl::Profiler* profiler);
    void scan(gl::Profiler* profiler);

    size_t particles_;
    CellGrid grid_;
    unsigned chunks_ = 0;
    bool counted_ = false;
    gl::Buffer slots_;       // a uvec2 a particle: its cell, and the particles counted there before it
    gl::Buffer cellNumbers_; // a uint a particle: particle numbers by cell
    gl::Buffer cellCounts_;  // a uint a cell
    gl::Buffer cellStarts_;  // a uint a cell, and one behind the last
    gl::BufferView countTexels_, startTexels_; // views of cellCounts_ and cellStarts_
    gl::Buffer chunkSums_;                     // a uint a chunk of cells
    const gl::Program& count_;
    const gl::Program& sumChunks_;
    const gl::Program& scan_;
    const gl::Program& scatter_;
    const gl::Program& gather_;
};

} // namespace meltpool
