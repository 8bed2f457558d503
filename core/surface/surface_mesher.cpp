#include "core/surface/surface_mesher.hpp"

#include "core/surface/cell_cases.hpp"
#include "core/surface/surface_barrier.hpp"

#include <cstddef>
#include <span>

namespace meltpool {

namespace {

void dispatchIndirect(const gl::Program& program, size_t command) {
    program.dispatchIndirect(command);
    surfaceBarrier();
}

} // namespace

SurfaceMesher::SurfaceMesher(gl::ShaderLibrary& shaders, const SurfaceGrid& grid, const gl::Buffer& commands)
    : shaders_(shaders),
      commands_(commands),
      listBlocksPass_(shaders.compute("surface/list_blocks.comp")),
      insidePass_(shaders.compute("surface/inside.comp")),
      countPass_(shaders.compute("surface/count.comp")),
      sumBlocksPass_(shaders.compute("surface/sum_blocks.comp")),
      placeBlocksPass_(shaders.compute("surface/place_blocks.comp")),
      listMeshPass_(shaders.compute("surface/list_mesh.comp")),
      vertexPass_(shaders.compute("surface/vertices.comp")),
      trianglePass_(shaders.compute("surface/triangles.comp")),
      blockStates_("surface block states", grid.blockCount() * 4),
      baseTriangles_("surface base triangles", grid.blockCount() * 8),
      blockList_("surface block list", grid.blockCount() * 4),
      obsoleteTriangles_("surface obsolete triangles", grid.blockCount() * 8),
      blockSums_("surface block sums", grid.blockCount() * 8),
      insideBits_("surface inside bits", grid.blockCount() * SURFACE_BLOCK_WORDS * 4),
      rows_("surface rows", grid.blockCount() * SURFACE_BLOCK_ROWS * 8),
      rowSums_("surface row sums", grid.blockCount() * SURFACE_BLOCK_ROWS * 4),
      cases_("surface cases", std::span<const std::uint32_t>(cellCaseTable())),
      insideTexels_("surface inside bits", insideBits_, GL_R32UI, 4),
      rowTexels_("surface rows", rows_, GL_RG32UI, 8),
      caseTexels_("surface cases", cases_, GL_R32UI, 4),
      edgeList_("surface edge list", grid.mostVertices() * 4),
      triangleList_("surface triangle list", grid.mostTriangles() * 8),
      vertices_("surface vertices", grid.mostVertices() * sizeof(SurfaceVertex)),
      indices_("surface indices", grid.mostTriangles() * 12) {}

void SurfaceMesher::take(int particleData) {
    const size_t most = vertices_.bytes() / sizeof(SurfaceVertex);
    if ((particleData & SURFACE_WITH_PEAKS) != 0 && !vertexPeaks_)
        vertexPeaks_ = gl::Buffer("surface vertex peaks", most * 4);
    if ((particleData & SURFACE_WITH_FREEZING) == 0 || freezing_) return;
    freezing_.emplace(
        Freezing{shaders_.compute("surface/vertices.comp", {{"SURFACE_FREEZING", "1"}, {"SURFACE_FLAT", "1"}}),
                 gl::Buffer("surface vertex freezing", most * sizeof(SurfaceFreezing))});
}

void SurfaceMesher::clear() {
    blockStates_.clear();
    insideBits_.clear();
}

void SurfaceMesher::listBlocks(const SurfaceVolumes& volumes) const {
    volumes.blockFlags().bindStorage(SURFACE_BIND_BLOCK_FLAGS);
    blockStates_.bindStorage(SURFACE_BIND_BLOCK_STATES);
    blockList_.bindStorage(SURFACE_BIND_BLOCK_LIST);
    baseTriangles_.bindStorage(SURFACE_BIND_BASE_TRIANGLES);
    obsoleteTriangles_.bindStorage(SURFACE_BIND_OBSOLETE_TRIANGLES);
    commands_.bindStorage(SURFACE_BIND_COMMANDS);
    listBlocksPass_.dispatchGroups(1);
    surfaceCommandBarrier();
}

/// Finds the inside corners of the listed blocks, and the number and offset of their vertices and triangles.
void SurfaceMesher::countMesh(const SurfaceVolumes& volumes) const {
    volumes.bindDensityTexels();
    insideBits_.bindStorage(SURFACE_BIND_INSIDE);
    dispatchIndirect(insidePass_, offsetof(SurfaceCommands, words));
    rowSums_.bindStorage(SURFACE_BIND_ROW_SUMS);
    caseTexels_.bind(SURFACE_TEXELS_CASES);
    insideTexels_.bind(SURFACE_TEXELS_INSIDE);
    indices_.bindStorage(SURFACE_BIND_INDICES);
    dispatchIndirect(countPass_, offsetof(SurfaceCommands, rows));
    blockSums_.bindStorage(SURFACE_BIND_BLOCK_SUMS);
    dispatchIndirect(sumBlocksPass_, offsetof(SurfaceCommands, blocks));
    blockStates_.bindStorage(SURFACE_BIND_BLOCK_STATES);
    placeBlocksPass_.dispatchGroups(1);
    surfaceCommandBarrier();
}

void SurfaceMesher::listMesh() const {
    rows_.bindStorage(SURFACE_BIND_ROWS);
    edgeList_.bindStorage(SURFACE_BIND_EDGE_LIST);
    triangleList_.bindStorage(SURFACE_BIND_TRIANGLE_LIST);
    dispatchIndirect(listMeshPass_, offsetof(SurfaceCommands, rows));
}

/// Without freezing times, the highest temperatures distinguish metal on the lattice from other metal.
const gl::Program& SurfaceMesher::chooseVertexPass(const SurfaceSetup& setup) {
    if ((setup.particleData & SURFACE_WITH_FREEZING) != 0) return freezing_->vertexPass;
    if (!vertexPeaks_ || setup.flatPlaneCount + setup.pipeCount == 0) return vertexPass_;
    if (flatVertexPass_ == nullptr)
        flatVertexPass_ = &shaders_.compute("surface/vertices.comp", {{"SURFACE_FLAT", "1"}});
    return *flatVertexPass_;
}

void SurfaceMesher::makeVertices(const SurfaceVolumes& volumes, const SurfaceSetup& setup) {
    volumes.bindDensityTexels();
    volumes.bindTemperatureTexels();
    vertices_.bindStorage(SURFACE_BIND_VERTICES);
    (vertexPeaks_ ? vertexPeaks_ : commands_).bindStorage(SURFACE_BIND_VERTEX_PEAKS);
    volumes.bindPeakTexels();
    if ((setup.particleData & SURFACE_WITH_FREEZING) != 0) {
        freezing_->vertices.bindStorage(SURFACE_BIND_VERTEX_FREEZING);
        volumes.bindFreezingTexels();
    }
    dispatchIndirect(chooseVertexPass(setup), offsetof(SurfaceCommands, vertices));
}

void SurfaceMesher::makeTriangles() const {
    rowTexels_.bind(SURFACE_TEXELS_ROWS);
    dispatchIndirect(trianglePass_, offsetof(SurfaceCommands, triangles));
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void SurfaceMesher::update(const SurfaceVolumes& volumes, const SurfaceSetup& setup, gl::Profiler* profiler) {
    {
        const gl::Scope scope(profiler, "surface count");
        listBlocks(volumes);
        countMesh(volumes);
    }
    {
        const gl::Scope scope(profiler, "surface list");
        listMesh();
    }
    {
        const gl::Scope scope(profiler, "surface vertices");
        makeVertices(volumes, setup);
    }
    {
        const gl::Scope scope(profiler, "surface triangles");
        makeTriangles();
    }
}

SurfaceMesh SurfaceMesher::mesh(int particleData) const {
    return {&vertices_, &indices_, &commands_, (particleData & SURFACE_WITH_PEAKS) != 0 ? &vertexPeaks_ : nullptr,
            (particleData & SURFACE_WITH_FREEZING) != 0 ? &freezing_->vertices : nullptr};
}

size_t SurfaceMesher::bytes() const {
    size_t sum = vertexPeaks_.bytes() + (freezing_ ? freezing_->vertices.bytes() : 0);
    for (const gl::Buffer* buffer :
         {&blockStates_, &baseTriangles_, &blockList_, &obsoleteTriangles_, &blockSums_, &insideBits_, &rows_,
          &rowSums_, &cases_, &edgeList_, &triangleList_, &vertices_, &indices_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
