#include "core/surface/surface.hpp"

#include "core/base/error.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/readback.hpp"
#include "core/surface/cell_cases.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <string>

namespace meltpool {

namespace {

constexpr GLbitfield kStorage = GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT;

int extrasOf(const ParticleView& particles) {
    return (particles.phases != nullptr ? SURFACE_WITH_PHASES : 0) |
           (particles.heats != nullptr ? SURFACE_WITH_PEAKS : 0);
}

SurfaceStatistics statisticsOf(const SurfaceCommands& commands) {
    return {commands.vertexCount,   commands.triangleCount, commands.blockCount,
            commands.splattedCount, commands.whole != 0,    commands.overflow != 0};
}

} // namespace

namespace {

/// How hot the metal has been: a third volume beside density and temperature, for particles that remember it.
struct Peaks {
    gl::Buffer volume, splatted, vertices; // a word a corner, a particle, a vertex
    gl::BufferView volumeTexels, heatTexels;
};

} // namespace

/// The passes and the memory they work on.
struct Surface::Work {
    Work(gl::ShaderLibrary& shaders, const SurfaceGrid& theGrid);

    void makeRoom(size_t particles);
    void forget();
    void makePeaks();
    void bindParticles(const ParticleView& particles);
    void bindPeaks(const ParticleView& particles);
    void enterAll(const ParticleView& particles);
    void enterChanged(const ParticleView& particles);
    void chooseBlocks();
    void countMesh();
    void makeMesh(gl::Profiler* profiler);
    void dispatchIndirect(const gl::Program& program, size_t command) const;

    SurfaceGrid grid;
    SurfaceSetup setup;
    SurfaceParameters made; ///< what the volumes were made with
    size_t entered = 0;     ///< particles that they may hold; 0 before the first update
    int extras = 0;         ///< SURFACE_WITH_* of the particles
    std::optional<Peaks> peaks;

    const gl::Program& compare;
    std::array<const gl::Program*, 2> splatAll, splatChanged; // by SurfaceKernel
    const gl::Program& listBlocks;
    const gl::Program& inside;
    const gl::Program& count;
    const gl::Program& sumBlocks;
    const gl::Program& placeBlocks;
    const gl::Program& listMesh;
    const gl::Program& vertexPass;
    const gl::Program& trianglePass;

    gl::Buffer setupBlock;
    gl::Buffer splatted, changedList; // a vec4 and a uint a particle
    gl::Buffer density, temperature;
    gl::BufferView particleTexels, splattedTexels, densityTexels, temperatureTexels;
    gl::Buffer blockFlags, blockStates, settled;
    gl::Buffer blockList, retired, blockSums;
    gl::Buffer insideBits, rows, rowSums;
    gl::Buffer cases;
    gl::BufferView insideTexels, rowTexels, caseTexels;
    gl::Buffer edgeList, triangleList;
    gl::Buffer vertices, indices, commands;
    gl::Readback readback;
};

Surface::Work::Work(gl::ShaderLibrary& shaders, const SurfaceGrid& theGrid)
    : grid(theGrid),
      setup(grid.setup()),
      compare(shaders.compute("surface/compare.comp")),
      splatAll{&shaders.compute("surface/splat.comp", {{"SURFACE_ANEW", "1"}}),
               &shaders.compute("surface/splat.comp", {{"SURFACE_ANEW", "1"}, {"SURFACE_SMOOTH", "1"}})},
      splatChanged{&shaders.compute("surface/splat.comp"),
                   &shaders.compute("surface/splat.comp", {{"SURFACE_SMOOTH", "1"}})},
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
      densityTexels("surface density", density, GL_R32UI, 4),
      temperatureTexels("surface temperature", temperature, GL_R32UI, 4),
      blockFlags("surface block flags", grid.blockCount() * 4),
      blockStates("surface block states", grid.blockCount() * 4),
      settled("surface settled", grid.blockCount() * 8),
      blockList("surface block list", grid.blockCount() * 4),
      retired("surface retired", grid.blockCount() * 8),
      blockSums("surface block sums", grid.blockCount() * 8),
      insideBits("surface inside bits", grid.blockCount() * SURFACE_BLOCK_WORDS * 4),
      rows("surface rows", grid.blockCount() * SURFACE_BLOCK_ROWS * 8),
      rowSums("surface row sums", grid.blockCount() * SURFACE_BLOCK_ROWS * 4),
      cases("surface cases", std::span<const std::uint32_t>(cellCaseTable())),
      insideTexels("surface inside bits", insideBits, GL_R32UI, 4),
      rowTexels("surface rows", rows, GL_RG32UI, 8),
      caseTexels("surface cases", cases, GL_R32UI, 4),
      edgeList("surface edge list", grid.mostVertices() * 4),
      triangleList("surface triangle list", grid.mostTriangles() * 8),
      vertices("surface vertices", grid.mostVertices() * sizeof(SurfaceVertex)),
      indices("surface indices", grid.mostTriangles() * 12),
      commands("surface commands", sizeof(SurfaceCommands)),
      readback("surface counts", sizeof(SurfaceCommands)) {
    SurfaceCommands start{};
    start.changed = {0, 1, 1};
    commands.writeValue(start);
    setupBlock.writeValue(setup); // for a look at the empty volumes
}

/// Grows what has an entry a particle.
void Surface::Work::makeRoom(size_t particles) {
    if (splatted && splatted.bytes() >= particles * sizeof(glm::vec4)) return;
    // Where filler comes, it comes a particle a frame: room for many, or every frame would begin anew.
    if (splatted) particles += particles / 8 + 1024;
    splatted = gl::Buffer("surface splatted particles", particles * sizeof(glm::vec4));
    changedList = gl::Buffer("surface changed particles", particles * 4);
    splattedTexels = gl::BufferView("surface splatted particles", splatted, GL_RGBA32F, sizeof(glm::vec4));
    entered = 0;
}

void Surface::Work::makePeaks() {
    if (!peaks) {
        peaks.emplace();
        peaks->volume = gl::Buffer("surface peaks", density.bytes());
        peaks->vertices = gl::Buffer("surface vertex peaks", grid.mostVertices() * 4);
        peaks->volumeTexels = gl::BufferView("surface peaks", peaks->volume, GL_R32UI, 4);
    }
    const size_t bytes = splatted ? splatted.bytes() / 4 : 4; // a float where the other has a vec4
    if (peaks->splatted.bytes() < bytes) peaks->splatted = gl::Buffer("surface splatted peaks", bytes);
}

/// Empties the volumes: no particle is entered any more.
void Surface::Work::forget() {
    for (const gl::Buffer* buffer : {&density, &temperature, &blockStates, &insideBits})
        buffer->clear();
    if (peaks) peaks->volume.clear();
    if (splatted) splatted.fill(std::bit_cast<GLuint>(SURFACE_NOWHERE));
    glMemoryBarrier(kStorage);
}

void Surface::Work::dispatchIndirect(const gl::Program& program, size_t command) const {
    program.dispatchIndirect(command);
    glMemoryBarrier(kStorage);
}

void Surface::Work::bindParticles(const ParticleView& particles) {
    // Made each time: the particles' buffer may be another one under the same name.
    particleTexels = gl::BufferView("surface particles", *particles.positions, GL_RGBA32F, sizeof(glm::vec4));
    particleTexels.bind(SURFACE_TEXELS_PARTICLES);
    // Passes without phases or memory of the particles never look there; drivers still want something bound.
    (particles.phases != nullptr ? *particles.phases : commands).bindStorage(SURFACE_BIND_PHASES);
    (splatted ? splatted : commands).bindStorage(SURFACE_BIND_SPLATTED);
    (changedList ? changedList : commands).bindStorage(SURFACE_BIND_CHANGED_LIST);
    density.bindStorage(SURFACE_BIND_DENSITY);
    temperature.bindStorage(SURFACE_BIND_TEMPERATURE);
    blockFlags.bindStorage(SURFACE_BIND_BLOCK_FLAGS);
    commands.bindStorage(SURFACE_BIND_COMMANDS);
    bindPeaks(particles);
}

void Surface::Work::bindPeaks(const ParticleView& particles) {
    (peaks ? peaks->volume : commands).bindStorage(SURFACE_BIND_PEAK);
    (peaks ? peaks->splatted : commands).bindStorage(SURFACE_BIND_SPLATTED_PEAKS);
    if (particles.heats == nullptr) return;
    peaks->heatTexels = gl::BufferView("surface heats", *particles.heats, GL_RGBA32F, sizeof(glm::vec4));
    peaks->heatTexels.bind(SURFACE_TEXELS_HEATS);
}

void Surface::Work::enterAll(const ParticleView& particles) {
    bindParticles(particles);
    splatAll[size_t(made.kernel)]->dispatch(particles.count, SURFACE_GROUP);
    glMemoryBarrier(kStorage);
}

void Surface::Work::enterChanged(const ParticleView& particles) {
    bindParticles(particles);
    splattedTexels.bind(SURFACE_TEXELS_SPLATTED);
    compare.dispatch(particles.count, SURFACE_GROUP);
    glMemoryBarrier(kStorage | GL_COMMAND_BARRIER_BIT);
    dispatchIndirect(*splatChanged[size_t(made.kernel)], offsetof(SurfaceCommands, changed));
}

void Surface::Work::chooseBlocks() {
    blockFlags.bindStorage(SURFACE_BIND_BLOCK_FLAGS);
    blockStates.bindStorage(SURFACE_BIND_BLOCK_STATES);
    blockList.bindStorage(SURFACE_BIND_BLOCK_LIST);
    settled.bindStorage(SURFACE_BIND_SETTLED);
    retired.bindStorage(SURFACE_BIND_RETIRED);
    commands.bindStorage(SURFACE_BIND_COMMANDS);
    listBlocks.dispatchGroups(1);
    glMemoryBarrier(kStorage | GL_COMMAND_BARRIER_BIT);
}

/// Finds the inside corners of the listed blocks, and how many vertices and triangles each gets and where.
void Surface::Work::countMesh() {
    densityTexels.bind(SURFACE_TEXELS_DENSITY);
    insideBits.bindStorage(SURFACE_BIND_INSIDE);
    dispatchIndirect(inside, offsetof(SurfaceCommands, words));
    rowSums.bindStorage(SURFACE_BIND_ROW_SUMS);
    caseTexels.bind(SURFACE_TEXELS_CASES);
    insideTexels.bind(SURFACE_TEXELS_INSIDE);
    indices.bindStorage(SURFACE_BIND_INDICES);
    dispatchIndirect(count, offsetof(SurfaceCommands, rows));
    blockSums.bindStorage(SURFACE_BIND_BLOCK_SUMS);
    dispatchIndirect(sumBlocks, offsetof(SurfaceCommands, blocks));
    blockStates.bindStorage(SURFACE_BIND_BLOCK_STATES);
    placeBlocks.dispatchGroups(1);
    glMemoryBarrier(kStorage | GL_COMMAND_BARRIER_BIT);
}

void Surface::Work::makeMesh(gl::Profiler* profiler) {
    {
        const gl::Scope scope(profiler, "surface list");
        rows.bindStorage(SURFACE_BIND_ROWS);
        edgeList.bindStorage(SURFACE_BIND_EDGE_LIST);
        triangleList.bindStorage(SURFACE_BIND_TRIANGLE_LIST);
        dispatchIndirect(listMesh, offsetof(SurfaceCommands, rows));
    }
    {
        const gl::Scope scope(profiler, "surface vertices");
        densityTexels.bind(SURFACE_TEXELS_DENSITY);
        temperatureTexels.bind(SURFACE_TEXELS_TEMPERATURE);
        vertices.bindStorage(SURFACE_BIND_VERTICES);
        (peaks ? peaks->vertices : commands).bindStorage(SURFACE_BIND_VERTEX_PEAKS);
        if (peaks) peaks->volumeTexels.bind(SURFACE_TEXELS_PEAK);
        dispatchIndirect(vertexPass, offsetof(SurfaceCommands, vertices));
    }
    {
        const gl::Scope scope(profiler, "surface triangles");
        rowTexels.bind(SURFACE_TEXELS_ROWS);
        dispatchIndirect(trianglePass, offsetof(SurfaceCommands, triangles));
        glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    }
}

Surface::Surface(gl::ShaderLibrary& shaders, const SurfaceParameters& wanted, glm::vec3 boxMin, glm::vec3 boxMax)
    : parameters(wanted), work_(std::make_unique<Work>(shaders, SurfaceGrid(wanted.cells, boxMin, boxMax))) {}

Surface::~Surface() = default;

void Surface::setTemperatureRange(float coldest, float hottest) {
    if (!(hottest > coldest)) throw InputError("the surface's temperature range is empty; expected coldest < hottest");
    if (work_->setup.origin.w == coldest && work_->setup.extent.w == hottest - coldest) return;
    work_->setup.origin.w = coldest;
    work_->setup.extent.w = hottest - coldest;
    work_->entered = 0;
}

bool Surface::mustStartAnew(const ParticleView& particles) const {
    const SurfaceParameters& made = work_->made;
    return !keeping.on || work_->entered == 0 || particles.count < work_->entered ||
           work_->extras != extrasOf(particles) || made.influence != parameters.influence ||
           made.kernel != std::clamp(parameters.kernel, 0, 1) || made.isoLevel != parameters.isoLevel ||
           made.caps != parameters.caps;
}

void Surface::update(const ParticleView& particles, gl::Profiler* profiler) {
    const gl::Scope all(profiler, "surface");
    Work& w = *work_;
    if (keeping.on) w.makeRoom(particles.count);
    const bool anew = mustStartAnew(particles);
    w.made = parameters;
    w.made.kernel = std::clamp(parameters.kernel, 0, 1);
    w.entered = keeping.on ? particles.count : 0;
    w.extras = extrasOf(particles);
    if (particles.heats != nullptr) w.makePeaks();
    w.setup.cells.w = std::clamp(parameters.influence, 1, 8);
    w.setup.limits.x = static_cast<unsigned>(particles.count);
    w.setup.limits.y = static_cast<unsigned>(std::max(std::lround(double(parameters.isoLevel) * SURFACE_UNIT), 1L));
    w.setup.options = {parameters.caps ? 1 : 0, anew ? 1 : 0, w.extras, keeping.on ? 1 : 0};
    w.setup.still = {keeping.stillCells, keeping.stillTemperature, 0, 0};
    w.setupBlock.writeValue(w.setup);
    w.setupBlock.bindUniform(SURFACE_BIND_SETUP);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, w.commands.name());
    if (anew) {
        const gl::Scope scope(profiler, "surface clear");
        w.forget();
    }
    {
        const gl::Scope scope(profiler, "surface splat");
        anew ? w.enterAll(particles) : w.enterChanged(particles);
    }
    {
        const gl::Scope scope(profiler, "surface count");
        w.chooseBlocks();
        w.countMesh();
    }
    w.makeMesh(profiler);
}

SurfaceMesh Surface::mesh() const {
    const bool withPeaks = (work_->extras & SURFACE_WITH_PEAKS) != 0;
    return {&work_->vertices, &work_->indices, &work_->commands, withPeaks ? &work_->peaks->vertices : nullptr};
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

void Surface::bindVolumes() const {
    work_->setupBlock.bindUniform(SURFACE_BIND_SETUP);
    work_->density.bindStorage(SURFACE_BIND_DENSITY);
    work_->temperature.bindStorage(SURFACE_BIND_TEMPERATURE);
}

size_t Surface::bytes() const {
    const Work& w = *work_;
    size_t sum = 0;
    for (const gl::Buffer* buffer :
         {&w.setupBlock, &w.splatted,  &w.changedList,  &w.density,   &w.temperature, &w.blockFlags, &w.blockStates,
          &w.settled,    &w.blockList, &w.retired,      &w.blockSums, &w.insideBits,  &w.rows,       &w.rowSums,
          &w.cases,      &w.edgeList,  &w.triangleList, &w.vertices,  &w.indices,     &w.commands})
        sum += buffer->bytes();
    if (w.peaks) sum += w.peaks->volume.bytes() + w.peaks->splatted.bytes() + w.peaks->vertices.bytes();
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
