// Puts the classic model's particles in the order of a uniform grid's cells, so that neighbours are found in short
// runs.
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

    /// Cells with the support radius as edge; larger where that would be more than 8 cells a particle.
    static CellGrid forRadius(float supportRadius, size_t particles);
};

/// A counting sort in passes: count, sums of chunks of cells, starts of cells, numbers by cell, copy in order.
class CellOrder {
  public:
    CellOrder(gl::ShaderLibrary& library, size_t particles);

    /// Takes another grid; what was counted is void.
    void setGrid(const CellGrid& grid);
    const CellGrid& grid() const { return grid_; }

    /// The cells that particles were counted into no longer fit them.
    void forgetCounts() { counted_ = false; }

    /// Binds its buffers for the passes that walk over neighbours and that count.
    void bind() const;

    /// Sorts what is bound as moved state into what is bound as sorted state. Counts first unless the pass that moved
    /// the particles has. Afterwards the counts are zero, to be filled by the pass that moves the particles next.
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
    gl::Buffer slots_;                         // a uvec2 a particle: cell, arrival in it
    gl::Buffer cellNumbers_;                   // a uint a particle: particle numbers by cell
    gl::Buffer cellCounts_;                    // a uint a cell
    gl::Buffer cellStarts_;                    // a uint a cell, and one behind the last
    gl::BufferView countTexels_, startTexels_; // of the two above
    gl::Buffer chunkSums_;                     // a uint a chunk of cells
    const gl::Program& count_;
    const gl::Program& sumChunks_;
    const gl::Program& scan_;
    const gl::Program& scatter_;
    const gl::Program& gather_;
};

} // namespace meltpool
