// Marching cubes: extraction of the surface's mesh from its volumes.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/surface/surface_grid.hpp"
#include "core/surface/surface_mesh.hpp"
#include "core/surface/surface_volumes.hpp"

#include <optional>

namespace meltpool {

/// Mesher of the grid's changed blocks, in the order that Surface describes. The GPU decides the numbers of blocks,
/// rows, vertices and triangles: the passes over them are dispatched indirectly.
class SurfaceMesher {
  public:
    /// `commands` (SurfaceCommands) must outlive this object; it holds the sizes of the passes and of the mesh.
    SurfaceMesher(gl::ShaderLibrary& shaders, const SurfaceGrid& grid, const gl::Buffer& commands);

    /// Makes the buffers that vertices need for particles with this data (bits SURFACE_WITH_*).
    void take(int particleData);
    /// Forgets the blocks of former updates; the barrier is left to SurfaceVolumes::clear(), which follows.
    void clear();
    /// Makes the mesh of the volumes. Expects `setup` to be bound, and the dispatch buffer to be `commands`.
    void update(const SurfaceVolumes& volumes, const SurfaceSetup& setup, gl::Profiler* profiler);

    /// Returns the mesh of particles with this data.
    SurfaceMesh mesh(int particleData) const;
    size_t bytes() const; ///< bytes of GPU memory

  private:
    /// Vertices with the freezing time of the metal around them.
    struct Freezing {
        const gl::Program& vertexPass;
        gl::Buffer vertices; // a SurfaceFreezing a vertex
    };

    const gl::Program& chooseVertexPass(const SurfaceSetup& setup);
    void listBlocks(const SurfaceVolumes& volumes) const;
    void countMesh(const SurfaceVolumes& volumes) const;
    void listMesh() const;
    void makeVertices(const SurfaceVolumes& volumes, const SurfaceSetup& setup);
    void makeTriangles() const;

    gl::ShaderLibrary& shaders_;
    const gl::Buffer& commands_;

    const gl::Program &listBlocksPass_, &insidePass_, &countPass_, &sumBlocksPass_, &placeBlocksPass_, &listMeshPass_,
        &vertexPass_, &trianglePass_;
    const gl::Program* flatVertexPass_ = nullptr; ///< made on first use

    gl::Buffer blockStates_, baseTriangles_, blockList_, obsoleteTriangles_, blockSums_;
    gl::Buffer insideBits_, rows_, rowSums_, cases_;
    gl::BufferView insideTexels_, rowTexels_, caseTexels_;
    gl::Buffer edgeList_, triangleList_;
    gl::Buffer vertices_, indices_;
    gl::Buffer vertexPeaks_; ///< a word a vertex; made for the first particles with highest temperatures
    std::optional<Freezing> freezing_;
};

} // namespace meltpool
