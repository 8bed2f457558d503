#include "core/surface/surface.hpp"

#include "core/base/error.hpp"
#include "core/gl/readback.hpp"
#include "core/surface/cell_cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace meltpool {

namespace {

constexpr GLbitfield kStorage = GL_SHADER_STORAGE_BARRIER_BIT;

SurfaceStatistics statisticsOf(const SurfaceCommands& commands) {
    return {commands.vertexCount, commands.triangleCount, commands.blockCount, commands.overflow != 0};
}

} // namespace

/// The passes and the memory they work on.
struct Surface::Work {
    Work(gl::ShaderLibrary& shaders, const SurfaceGrid& theGrid);

    void clear() const;
    void bind(const gl::Buffer& particles) const;
    void dispatchIndirect(const gl::Program& program, size_t command) const;

    SurfaceGrid grid;
    SurfaceSetup setup;

    const gl::Program& splat;
    const gl::Program& listBlocks;
    const gl::Program& inside;
    const gl::Program& count;
    const gl::Program& sumBlocks;
    const gl::Program& placeBlocks;
    const gl::Program& listMesh;
    const gl::Program& vertexPass;
    const gl::Program& trianglePass;

    gl::Buffer setupBlock;
    gl::Buffer density, temperature;
    gl::Buffer blockFlags, blockList, blockSums;
    gl::Buffer insideBits, rows, rowSums;
    gl::Buffer cases;
    gl::Buffer edgeList, triangleList;
    gl::Buffer vertices, indices, commands;
    gl::Readback readback;
};

Surface::Work::Work(gl::ShaderLibrary& shaders, const SurfaceGrid& theGrid)
    : grid(theGrid),
      setup(grid.setup()),
      splat(shaders.compute("surface/splat.comp")),
      listBlocks(shaders.compute("surface/list_blocks.comp")),
      inside(shaders.compute("surface/inside.comp")),
      count(shaders.compute("surface/count.comp")),
      sumBlocks(shaders.compute("surface/sum_blocks.comp")),
      placeBlocks(shaders.compute("surface/place_blocks.comp")),
      listMesh(shaders.compute("surface/list_mesh.comp")),
      vertexPass(shaders.compute("surface/vertices.comp")),
      trianglePass(shaders.compute("surface/triangles.comp")),
      setupBlock("surface setup", sizeof(SurfaceSetup)),
      density("surface density", grid.blockCount() * SURFACE_BLOCK_CORNERS * 4),
      temperature("surface temperature", grid.blockCount() * SURFACE_BLOCK_CORNERS * 4),
      blockFlags("surface block flags", grid.blockCount() * 4),
      blockList("surface block list", grid.blockCount() * 4),
      blockSums("surface block sums", grid.blockCount() * 8),
      insideBits("surface inside bits", grid.blockCount() * SURFACE_BLOCK_WORDS * 4),
      rows("surface rows", grid.blockCount() * SURFACE_BLOCK_ROWS * 8),
      rowSums("surface row sums", grid.blockCount() * SURFACE_BLOCK_ROWS * 4),
      cases("surface cases", std::span<const std::uint32_t>(cellCaseTable())),
      edgeList("surface edge list", grid.mostVertices() * 4),
      triangleList("surface triangle list", grid.mostTriangles() * 8),
      vertices("surface vertices", grid.mostVertices() * sizeof(SurfaceVertex)),
      indices("surface indices", grid.mostTriangles() * 12),
      commands("surface commands", sizeof(SurfaceCommands)),
      readback("surface counts", sizeof(SurfaceCommands)) {}

void Surface::Work::clear() const {
    for (const gl::Buffer* buffer : {&density, &temperature, &blockFlags, &insideBits})
        buffer->clear();
    glMemoryBarrier(kStorage);
}

void Surface::Work::bind(const gl::Buffer& particles) const {
    setupBlock.bindUniform(SURFACE_BIND_SETUP);
    particles.bindStorage(SURFACE_BIND_PARTICLES);
    density.bindStorage(SURFACE_BIND_DENSITY);
    temperature.bindStorage(SURFACE_BIND_TEMPERATURE);
    blockFlags.bindStorage(SURFACE_BIND_BLOCK_FLAGS);
    blockList.bindStorage(SURFACE_BIND_BLOCK_LIST);
    blockSums.bindStorage(SURFACE_BIND_BLOCK_SUMS);
    insideBits.bindStorage(SURFACE_BIND_INSIDE);
    rows.bindStorage(SURFACE_BIND_ROWS);
    rowSums.bindStorage(SURFACE_BIND_ROW_SUMS);
    cases.bindStorage(SURFACE_BIND_CASES);
    edgeList.bindStorage(SURFACE_BIND_EDGE_LIST);
    triangleList.bindStorage(SURFACE_BIND_TRIANGLE_LIST);
    vertices.bindStorage(SURFACE_BIND_VERTICES);
    indices.bindStorage(SURFACE_BIND_INDICES);
    commands.bindStorage(SURFACE_BIND_COMMANDS);
}

void Surface::Work::dispatchIndirect(const gl::Program& program, size_t command) const {
    program.use();
    glDispatchComputeIndirect(static_cast<GLintptr>(command));
    glMemoryBarrier(kStorage);
}

Surface::Surface(gl::ShaderLibrary& shaders, const SurfaceParameters& wanted, glm::vec3 boxMin, glm::vec3 boxMax)
    : parameters(wanted), work_(std::make_unique<Work>(shaders, SurfaceGrid(wanted.cells, boxMin, boxMax))) {}

Surface::~Surface() = default;

void Surface::setTemperatureRange(float coldest, float hottest) {
    if (!(hottest > coldest)) throw InputError("the surface's temperature range is empty; expected coldest < hottest");
    work_->setup.origin.w = coldest;
    work_->setup.extent.w = hottest - coldest;
}

void Surface::update(const ParticleView& particles, gl::Profiler* profiler) {
    const gl::Scope all(profiler, "surface");
    Work& w = *work_;
    w.setup.cells.w = std::clamp(parameters.influence, 1, 8);
    w.setup.limits.x = static_cast<unsigned>(particles.count);
    w.setup.limits.y = static_cast<unsigned>(std::max(std::lround(double(parameters.isoLevel) * SURFACE_UNIT), 1L));
    w.setup.options.x = parameters.caps ? 1 : 0;
    w.setupBlock.writeValue(w.setup);
    w.bind(*particles.positions);
    {
        const gl::Scope scope(profiler, "surface clear");
        w.clear();
    }
    {
        const gl::Scope scope(profiler, "surface splat");
        w.splat.dispatch(particles.count, SURFACE_GROUP);
        glMemoryBarrier(kStorage);
    }
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, w.commands.name());
    {
        const gl::Scope scope(profiler, "surface inside");
        w.listBlocks.dispatchGroups(1);
        glMemoryBarrier(kStorage | GL_COMMAND_BARRIER_BIT);
        w.dispatchIndirect(w.inside, offsetof(SurfaceCommands, words));
    }
    {
        const gl::Scope scope(profiler, "surface count");
        w.dispatchIndirect(w.count, offsetof(SurfaceCommands, rows));
        w.dispatchIndirect(w.sumBlocks, offsetof(SurfaceCommands, blocks));
        w.placeBlocks.dispatchGroups(1);
        glMemoryBarrier(kStorage | GL_COMMAND_BARRIER_BIT);
    }
    {
        const gl::Scope scope(profiler, "surface list");
        w.dispatchIndirect(w.listMesh, offsetof(SurfaceCommands, rows));
    }
    {
        const gl::Scope scope(profiler, "surface vertices");
        w.dispatchIndirect(w.vertexPass, offsetof(SurfaceCommands, vertices));
    }
    {
        const gl::Scope scope(profiler, "surface triangles");
        w.dispatchIndirect(w.trianglePass, offsetof(SurfaceCommands, triangles));
        glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    }
}

SurfaceMesh Surface::mesh() const {
    return {&work_->vertices, &work_->indices, &work_->commands};
}

const SurfaceGrid& Surface::grid() const {
    return work_->grid;
}

const gl::Buffer& Surface::densityVolume() const {
    return work_->density;
}

const gl::Buffer& Surface::temperatureVolume() const {
    return work_->temperature;
}

size_t Surface::bytes() const {
    const Work& w = *work_;
    size_t sum = 0;
    for (const gl::Buffer* buffer :
         {&w.setupBlock, &w.density, &w.temperature, &w.blockFlags, &w.blockList, &w.blockSums, &w.insideBits, &w.rows,
          &w.rowSums, &w.cases, &w.edgeList, &w.triangleList, &w.vertices, &w.indices, &w.commands})
        sum += buffer->bytes();
    return sum;
}

SurfaceStatistics Surface::statistics() const {
    return statisticsOf(work_->commands.read<SurfaceCommands>(1).front());
}

void Surface::requestStatistics() {
    work_->readback.request(work_->commands);
}

std::optional<SurfaceStatistics> Surface::pollStatistics() {
    const auto commands = work_->readback.poll<SurfaceCommands>();
    return commands ? std::optional(statisticsOf(*commands)) : std::nullopt;
}

} // namespace meltpool
