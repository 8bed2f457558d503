#include "core/metal/classic/cell_order.hpp"

#include "core/gl/order.hpp"

#include "shaders/shared/classic.h"
#include "shaders/shared/dispatch.h"

#include <algorithm>
#include <cmath>

namespace meltpool {

CellGrid CellGrid::forRadius(float supportRadius, size_t particles) {
    // Slightly more than h, so that rounding of the cell index never puts two neighbours two cells apart.
    const double edge = static_cast<double>(supportRadius) * 1.0001;
    const double most = std::floor(std::cbrt(8.0 * static_cast<double>(particles)) + 1e-9);
    const double perAxis = std::clamp(std::ceil(2.0 / edge), 1.0, std::max(most, 1.0));
    return {static_cast<unsigned>(perAxis), static_cast<float>(1.0 / std::max(edge, 2.0 / perAxis))};
}

CellOrder::CellOrder(gl::ShaderLibrary& library, size_t particles)
    : particles_(particles),
      slots_("classic cell slots", particles * sizeof(uvec2)),
      cellNumbers_("classic cell numbers", particles * sizeof(uint)),
      count_(library.compute("metal/classic/count.comp")),
      sumChunks_(library.compute("metal/classic/chunk_sums.comp")),
      scan_(library.compute("metal/classic/scan.comp")),
      scatter_(library.compute("metal/classic/scatter.comp")),
      gather_(library.compute("metal/classic/gather.comp")) {
    setGrid(grid_);
}

void CellOrder::setGrid(const CellGrid& grid) {
    grid_ = grid;
    counted_ = false;
    const unsigned chunks = grid.cells() / CLASSIC_SCAN_CELLS + 1; // includes the end of the last cell
    if (chunks == chunks_) return;
    chunks_ = chunks;
    const size_t padded = static_cast<size_t>(chunks) * CLASSIC_SCAN_CELLS;
    cellCounts_ = gl::Buffer("classic cell counts", padded * sizeof(uint));
    cellStarts_ = gl::Buffer("classic cell starts", padded * sizeof(uint));
    countTexels_ = gl::BufferView("classic cell count texels", cellCounts_, GL_RGBA32UI, sizeof(uvec4));
    startTexels_ = gl::BufferView("classic cell start texels", cellStarts_, GL_R32UI, sizeof(uint));
    chunkSums_ = gl::Buffer("classic chunk sums", chunks * sizeof(uint));
}

void CellOrder::bind() const {
    slots_.bindStorage(CLASSIC_CELL_SLOTS);
    cellNumbers_.bindStorage(CLASSIC_CELL_NUMBERS);
    cellCounts_.bindStorage(CLASSIC_CELL_COUNTS);
    cellStarts_.bindStorage(CLASSIC_CELL_STARTS);
    chunkSums_.bindStorage(CLASSIC_CHUNK_SUMS);
    countTexels_.bind(CLASSIC_COUNT_TEXELS);
    startTexels_.bind(CLASSIC_START_TEXELS);
}

void CellOrder::sort(gl::Profiler* profiler) {
    if (!counted_) count(profiler);
    scan(profiler);
    {
        const gl::Scope scope(profiler, "classic scatter");
        scatter_.dispatch(particles_, GROUP_SIZE);
        gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    const gl::Scope scope(profiler, "classic gather");
    gather_.dispatch(particles_, GROUP_SIZE);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

/// Reads moved positions, writes slots and counts.
void CellOrder::count(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "classic count");
    cellCounts_.clear();
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    count_.dispatch(particles_, GROUP_SIZE);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// Reads counts, writes starts; zeroes the counts.
void CellOrder::scan(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "classic scan");
    sumChunks_.dispatchGroups(chunks_);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    scan_.dispatchGroups(chunks_);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    cellCounts_.clear();
    counted_ = true;
}

size_t CellOrder::bytes() const {
    return slots_.bytes() + cellNumbers_.bytes() + cellCounts_.bytes() + cellStarts_.bytes() + chunkSums_.bytes();
}

} // namespace meltpool
