#include "core/surface/surface.hpp"

#include "core/base/error.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/readback.hpp"
#include "core/metal/state/metal_state.hpp"
#include "core/surface/cell_cases.hpp"
#include "core/surface/splat_passes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace meltpool {

namespace {

constexpr GLbitfield kStorage = GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT;

int dataOf(const ParticleView& particles) {
    return (particles.phases != nullptr ? SURFACE_WITH_PHASES : 0) |
           (particles.heats != nullptr ? SURFACE_WITH_PEAKS : 0) |
           (particles.frozenAt != nullptr ? SURFACE_WITH_FREEZING : 0) |
           (particles.numbers != nullptr ? SURFACE_WITH_NUMBERS : 0);
}

SurfaceStatistics statisticsOf(const SurfaceCommands& commands) {
    return {commands.vertexCount,   commands.triangleCount, commands.blockCount,
            commands.splattedCount, commands.rebuilt != 0,  commands.overflow != 0};
}

/// Highest temperature so far: a third volume, for particles that store it.
struct Peaks {
    gl::Buffer volume, splatted, vertices; // a word a corner, a particle, a vertex
    gl::BufferView volumeTexels, heatTexels;
};

/// When metal froze: a volume of two words a corner.
struct Freezing {
    explicit Freezing(gl::ShaderLibrary& shaders)
        : vertexPass(shaders.compute("surface/vertices.comp", {{"SURFACE_FREEZING", "1"}, {"SURFACE_FLAT", "1"}})) {}

    const gl::Program& vertexPass;
    gl::Buffer volume, splatted, vertices; // two words a corner, one a particle, a SurfaceFreezing a vertex
    gl::BufferView volumeTexels, particleTexels, splattedTexels;
};

/// Share of the solidus in K up to which metal of the lattice is taken to lie as it did: hotter metal has neighbours
/// that melted. None: chosen; at the toe of a bead on steel it is 2 mm.
constexpr float kFlatBelow = 0.65F;

/// What stands for a weight of 1 in the freezing volume: the wider a particle reaches, the more of them meet in a
/// corner, whose sum of at most one particle a cell must not exceed 4096.
float freezingUnit(int influence) {
    constexpr float kFinest = 64, kCoarsest = 4, kInReach = 8000;
    const auto across = static_cast<float>(2 * influence - 1);
    return std::clamp(std::floor(kInReach / (across * across * across)), kCoarsest, kFinest);
}

} // namespace

/// The compute passes and their buffers.
struct Surface::Work {
    Work(gl::ShaderLibrary& theShaders, const SurfaceGrid& theGrid);

    void growParticleBuffers(size_t particles);
    void clearVolumes();
    void makePeaks();
    void makeFreezing();
    void bindParticles(const ParticleView& particles);
    void bindPeaks(const ParticleView& particles);
    void bindFreezing(const ParticleView& particles);
    void bindLattice(const ParticleView& particles);
    const SplatPasses& passes() { return splatters.passes(particleData, used.kernel); }
    const gl::Program& chooseVertexPass();
    void splatAll(const ParticleView& particles);
    void splatChanged(const ParticleView& particles);
    void listBlocks();
    void countMesh();
    void makeMesh(gl::Profiler* profiler);
    void dispatchIndirect(const gl::Program& program, size_t command) const;

    bool withFreezing() const { return (particleData & SURFACE_WITH_FREEZING) != 0; }

    gl::ShaderLibrary& shaders;
    SurfaceGrid grid;
    SurfaceSetup setup;
    SurfaceParameters used;   ///< parameters that the volumes were made with
    size_t splattedCount = 0; ///< particles in the volumes; 0: the next update rebuilds
    int particleData = 0;     ///< SURFACE_WITH_* of the particles
    std::optional<Peaks> peaks;
    std::optional<Freezing> freezing;

    SplatPassLibrary splatters;
    const gl::Program& listBlocksPass;
    const gl::Program& insidePass;
    const gl::Program& countPass;
    const gl::Program& sumBlocksPass;
    const gl::Program& placeBlocksPass;
    const gl::Program& listMeshPass;
    const gl::Program& vertexPass;
    const gl::Program* flatVertexPass = nullptr; ///< made when it is asked for
    const gl::Program& trianglePass;

    gl::Buffer setupBlock;
    gl::Buffer splatted, changedList; // a vec4 and a uint a particle
    gl::Buffer density, temperature;
    gl::BufferView particleTexels, splattedTexels, densityTexels, temperatureTexels, latticeTexels, numberTexels;
    gl::Buffer blockFlags, blockStates, baseTriangles;
    gl::Buffer blockList, obsoleteTriangles, blockSums;
    gl::Buffer insideBits, rows, rowSums;
    gl::Buffer cases;
    gl::BufferView insideTexels, rowTexels, caseTexels;
    gl::Buffer edgeList, triangleList;
    gl::Buffer vertices, indices, commands;
    gl::Readback readback;
};

Surface::Work::Work(gl::ShaderLibrary& theShaders, const SurfaceGrid& theGrid)
    : shaders(theShaders),
      grid(theGrid),
      setup(grid.setup()),
      splatters(shaders),
      listBlocksPass(shaders.compute("surface/list_blocks.comp")),
      insidePass(shaders.compute("surface/inside.comp")),
      countPass(shaders.compute("surface/count.comp")),
      sumBlocksPass(shaders.compute("surface/sum_blocks.comp")),
      placeBlocksPass(shaders.compute("surface/place_blocks.comp")),
      listMeshPass(shaders.compute("surface/list_mesh.comp")),
      vertexPass(shaders.compute("surface/vertices.comp")),
      trianglePass(shaders.compute("surface/triangles.comp")),
      setupBlock("surface setup", sizeof(SurfaceSetup)),
      density("surface density", grid.blockCount() * SURFACE_BLOCK_CORNERS * 4),
      temperature("surface temperature", grid.blockCount() * SURFACE_BLOCK_CORNERS * 4),
      densityTexels("surface density", density, GL_R32UI, 4),
      temperatureTexels("surface temperature", temperature, GL_R32UI, 4),
      blockFlags("surface block flags", grid.blockCount() * 4),
      blockStates("surface block states", grid.blockCount() * 4),
      baseTriangles("surface base triangles", grid.blockCount() * 8),
      blockList("surface block list", grid.blockCount() * 4),
      obsoleteTriangles("surface obsolete triangles", grid.blockCount() * 8),
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
    setupBlock.writeValue(setup); // the volumes can be queried before the first update
}

/// Makes the buffers with an entry a particle large enough.
void Surface::Work::growParticleBuffers(size_t particles) {
    if (splatted && splatted.bytes() >= particles * sizeof(glm::vec4)) return;
    // Filler adds a particle in every frame: without spare room every frame would rebuild.
    if (splatted) particles += particles / 8 + 1024;
    splatted = gl::Buffer("surface splatted particles", particles * sizeof(glm::vec4));
    changedList = gl::Buffer("surface changed particles", particles * 4);
    splattedTexels = gl::BufferView("surface splatted particles", splatted, GL_RGBA32F, sizeof(glm::vec4));
    splattedCount = 0;
}

void Surface::Work::makePeaks() {
    if (!peaks) {
        peaks.emplace();
        peaks->volume = gl::Buffer("surface peaks", density.bytes());
        peaks->vertices = gl::Buffer("surface vertex peaks", grid.mostVertices() * 4);
        peaks->volumeTexels = gl::BufferView("surface peaks", peaks->volume, GL_R32UI, 4);
    }
    const size_t bytes = splatted ? splatted.bytes() / 4 : 4; // a float a particle instead of a vec4
    if (peaks->splatted.bytes() < bytes) peaks->splatted = gl::Buffer("surface splatted peaks", bytes);
}

void Surface::Work::makeFreezing() {
    if (!freezing) {
        freezing.emplace(shaders);
        freezing->volume = gl::Buffer("surface freezing", 2 * density.bytes());
        freezing->vertices = gl::Buffer("surface vertex freezing", grid.mostVertices() * sizeof(SurfaceFreezing));
        freezing->volumeTexels = gl::BufferView("surface freezing", freezing->volume, GL_RG32UI, 8);
    }
    const size_t bytes = splatted ? splatted.bytes() / 4 : 4; // a float a particle instead of a vec4
    if (freezing->splatted.bytes() >= bytes) return;
    freezing->splatted = gl::Buffer("surface splatted freezing times", bytes);
    freezing->splattedTexels = gl::BufferView("surface splatted freezing times", freezing->splatted, GL_R32F, 4);
}

/// Empties the volumes and marks every particle as not splatted.
void Surface::Work::clearVolumes() {
    for (const gl::Buffer* buffer : {&density, &temperature, &blockStates, &insideBits})
        buffer->clear();
    if (peaks) peaks->volume.clear();
    if (withFreezing()) freezing->volume.clear();
    if (splatted) splatted.fill(std::bit_cast<GLuint>(SURFACE_NOWHERE));
    glMemoryBarrier(kStorage);
}

void Surface::Work::dispatchIndirect(const gl::Program& program, size_t command) const {
    program.dispatchIndirect(command);
    glMemoryBarrier(kStorage);
}

void Surface::Work::bindParticles(const ParticleView& particles) {
    // A new view for each update: another buffer of particles may have the same GL name.
    particleTexels = gl::BufferView("surface particles", *particles.positions, GL_RGBA32F, sizeof(glm::vec4));
    particleTexels.bind(SURFACE_TEXELS_PARTICLES);
    // Passes that do not read phases or splatted particles still need a buffer bound there.
    (particles.phases != nullptr ? *particles.phases : commands).bindStorage(SURFACE_BIND_PHASES);
    (splatted ? splatted : commands).bindStorage(SURFACE_BIND_SPLATTED);
    (changedList ? changedList : commands).bindStorage(SURFACE_BIND_CHANGED_LIST);
    density.bindStorage(SURFACE_BIND_DENSITY);
    temperature.bindStorage(SURFACE_BIND_TEMPERATURE);
    blockFlags.bindStorage(SURFACE_BIND_BLOCK_FLAGS);
    commands.bindStorage(SURFACE_BIND_COMMANDS);
    bindPeaks(particles);
    if (withFreezing()) bindFreezing(particles);
    bindLattice(particles);
    if (particles.numbers == nullptr) return;
    numberTexels = gl::BufferView("surface numbers", *particles.numbers, GL_R32UI, sizeof(unsigned));
    numberTexels.bind(SURFACE_TEXELS_NUMBERS);
}

void Surface::Work::bindPeaks(const ParticleView& particles) {
    (peaks ? peaks->volume : commands).bindStorage(SURFACE_BIND_PEAK);
    (peaks ? peaks->splatted : commands).bindStorage(SURFACE_BIND_SPLATTED_PEAKS);
    if (particles.heats == nullptr) return;
    peaks->heatTexels = gl::BufferView("surface heats", *particles.heats, GL_RGBA32F, sizeof(glm::vec4));
    peaks->heatTexels.bind(SURFACE_TEXELS_HEATS);
}

void Surface::Work::bindFreezing(const ParticleView& particles) {
    freezing->volume.bindStorage(SURFACE_BIND_FREEZING);
    freezing->splatted.bindStorage(SURFACE_BIND_SPLATTED_FREEZING);
    freezing->particleTexels = gl::BufferView("surface freezing times", *particles.frozenAt, GL_R32F, sizeof(float));
    freezing->particleTexels.bind(SURFACE_TEXELS_FROZEN_AT);
}

void Surface::Work::bindLattice(const ParticleView& particles) {
    if (particles.lattice == nullptr) return;
    latticeTexels = gl::BufferView("surface lattice", *particles.latticeSlots, GL_R32UI, 4);
    latticeTexels.bind(SURFACE_TEXELS_LATTICE);
}

/// Without times of freezing, the highest temperatures tell metal on the lattice from other metal.
const gl::Program& Surface::Work::chooseVertexPass() {
    if (withFreezing()) return freezing->vertexPass;
    if (!peaks || setup.flatPlaneCount + setup.pipeCount == 0) return vertexPass;
    if (flatVertexPass == nullptr) flatVertexPass = &shaders.compute("surface/vertices.comp", {{"SURFACE_FLAT", "1"}});
    return *flatVertexPass;
}

void Surface::Work::splatAll(const ParticleView& particles) {
    bindParticles(particles);
    passes().splatAll.dispatch(particles.count, SURFACE_GROUP);
    glMemoryBarrier(kStorage);
}

void Surface::Work::splatChanged(const ParticleView& particles) {
    bindParticles(particles);
    splattedTexels.bind(SURFACE_TEXELS_SPLATTED);
    if (withFreezing()) freezing->splattedTexels.bind(SURFACE_TEXELS_FREEZING);
    passes().compare.dispatch(particles.count, SURFACE_GROUP);
    glMemoryBarrier(kStorage | GL_COMMAND_BARRIER_BIT);
    dispatchIndirect(passes().splatChanged, offsetof(SurfaceCommands, changed));
}

void Surface::Work::listBlocks() {
    blockFlags.bindStorage(SURFACE_BIND_BLOCK_FLAGS);
    blockStates.bindStorage(SURFACE_BIND_BLOCK_STATES);
    blockList.bindStorage(SURFACE_BIND_BLOCK_LIST);
    baseTriangles.bindStorage(SURFACE_BIND_BASE_TRIANGLES);
    obsoleteTriangles.bindStorage(SURFACE_BIND_OBSOLETE_TRIANGLES);
    commands.bindStorage(SURFACE_BIND_COMMANDS);
    listBlocksPass.dispatchGroups(1);
    glMemoryBarrier(kStorage | GL_COMMAND_BARRIER_BIT);
}

/// Finds the inside corners of the listed blocks, and the number and offset of their vertices and triangles.
void Surface::Work::countMesh() {
    densityTexels.bind(SURFACE_TEXELS_DENSITY);
    insideBits.bindStorage(SURFACE_BIND_INSIDE);
    dispatchIndirect(insidePass, offsetof(SurfaceCommands, words));
    rowSums.bindStorage(SURFACE_BIND_ROW_SUMS);
    caseTexels.bind(SURFACE_TEXELS_CASES);
    insideTexels.bind(SURFACE_TEXELS_INSIDE);
    indices.bindStorage(SURFACE_BIND_INDICES);
    dispatchIndirect(countPass, offsetof(SurfaceCommands, rows));
    blockSums.bindStorage(SURFACE_BIND_BLOCK_SUMS);
    dispatchIndirect(sumBlocksPass, offsetof(SurfaceCommands, blocks));
    blockStates.bindStorage(SURFACE_BIND_BLOCK_STATES);
    placeBlocksPass.dispatchGroups(1);
    glMemoryBarrier(kStorage | GL_COMMAND_BARRIER_BIT);
}

void Surface::Work::makeMesh(gl::Profiler* profiler) {
    {
        const gl::Scope scope(profiler, "surface list");
        rows.bindStorage(SURFACE_BIND_ROWS);
        edgeList.bindStorage(SURFACE_BIND_EDGE_LIST);
        triangleList.bindStorage(SURFACE_BIND_TRIANGLE_LIST);
        dispatchIndirect(listMeshPass, offsetof(SurfaceCommands, rows));
    }
    {
        const gl::Scope scope(profiler, "surface vertices");
        densityTexels.bind(SURFACE_TEXELS_DENSITY);
        temperatureTexels.bind(SURFACE_TEXELS_TEMPERATURE);
        vertices.bindStorage(SURFACE_BIND_VERTICES);
        (peaks ? peaks->vertices : commands).bindStorage(SURFACE_BIND_VERTEX_PEAKS);
        if (peaks) peaks->volumeTexels.bind(SURFACE_TEXELS_PEAK);
        if (withFreezing()) {
            freezing->vertices.bindStorage(SURFACE_BIND_VERTEX_FREEZING);
            freezing->volumeTexels.bind(SURFACE_TEXELS_FREEZING);
        }
        dispatchIndirect(chooseVertexPass(), offsetof(SurfaceCommands, vertices));
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
    SurfaceSetup& setup = work_->setup;
    if (setup.coldest == coldest && setup.temperatureRange == hottest - coldest) return;
    setup.coldest = coldest;
    setup.temperatureRange = hottest - coldest;
    work_->splattedCount = 0;
}

bool Surface::mustRebuild(const ParticleView& particles) const {
    const SurfaceParameters& used = work_->used;
    return !incremental.enabled || work_->splattedCount == 0 || particles.count < work_->splattedCount ||
           work_->particleData != dataOf(particles) || used.influence != parameters.influence ||
           used.kernel != std::clamp(parameters.kernel, 0, 1) || used.isoLevel != parameters.isoLevel ||
           used.caps != parameters.caps;
}

void Surface::writeSetup(const ParticleView& particles, bool rebuild) {
    SurfaceSetup& setup = work_->setup;
    setup.influence = std::clamp(parameters.influence, 1, 8);
    setup.particleCount = static_cast<unsigned>(particles.count);
    setup.isoLevel = static_cast<unsigned>(std::max(std::lround(double(parameters.isoLevel) * SURFACE_UNIT), 1L));
    setup.caps = parameters.caps ? 1 : 0;
    setup.rebuild = rebuild ? 1 : 0;
    setup.particleData = work_->particleData;
    setup.freezingUnit = freezingUnit(setup.influence);
    setup.latticeTiles = ivec3(0);
    setup.flatPlaneCount = setup.pipeCount = 0;
    if (const MetalLattice* lattice = particles.lattice) {
        setup.latticeOrigin = lattice->low;
        setup.perLatticeSpacing = 1 / lattice->spacing;
        setup.latticeTiles = lattice->tiles;
        setup.flatPlaneCount = flatFaces.count;
        for (size_t i = 0; i < size_t(flatFaces.count); ++i)
            setup.flatPlanes[i] = vec4((flatFaces.corners[i] - lattice->low) / lattice->spacing, 0);
        setup.pipeCount = roundFaces.outer > 0 ? 1 : 0;
        setup.pipeAxis = roundFaces.axis;
        setup.pipeLow = roundFaces.low;
        setup.pipeHigh = roundFaces.high;
        setup.pipeOuter = roundFaces.outer;
        setup.pipeInner = roundFaces.inner;
        setup.flatBelow = particles.solidus > 0 ? kFlatBelow * particles.solidus : std::numeric_limits<float>::max();
    }
    setup.incremental = incremental.enabled ? 1 : 0;
    setup.positionTolerance = incremental.positionTolerance;
    setup.temperatureTolerance = incremental.temperatureTolerance;
    work_->setupBlock.writeValue(setup);
    work_->setupBlock.bindUniform(SURFACE_BIND_SETUP);
}

void Surface::update(const ParticleView& particles, gl::Profiler* profiler) {
    const gl::Scope all(profiler, "surface");
    Work& w = *work_;
    if (incremental.enabled) w.growParticleBuffers(particles.count);
    const bool rebuild = mustRebuild(particles);
    w.used = parameters;
    w.used.kernel = std::clamp(parameters.kernel, 0, 1);
    w.splattedCount = incremental.enabled ? particles.count : 0;
    w.particleData = dataOf(particles);
    if (particles.heats != nullptr) w.makePeaks();
    if (w.withFreezing()) w.makeFreezing();
    writeSetup(particles, rebuild);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, w.commands.name());
    if (rebuild) {
        const gl::Scope scope(profiler, "surface clear");
        w.clearVolumes();
    }
    {
        const gl::Scope scope(profiler, "surface splat");
        rebuild ? w.splatAll(particles) : w.splatChanged(particles);
    }
    {
        const gl::Scope scope(profiler, "surface count");
        w.listBlocks();
        w.countMesh();
    }
    w.makeMesh(profiler);
}

SurfaceMesh Surface::mesh() const {
    const bool withPeaks = (work_->particleData & SURFACE_WITH_PEAKS) != 0;
    return {&work_->vertices, &work_->indices, &work_->commands, withPeaks ? &work_->peaks->vertices : nullptr,
            work_->withFreezing() ? &work_->freezing->vertices : nullptr};
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

const gl::Buffer* Surface::freezingVolume() const {
    return work_->withFreezing() ? &work_->freezing->volume : nullptr;
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
         {&w.setupBlock, &w.splatted,     &w.changedList,   &w.density,   &w.temperature,
          &w.blockFlags, &w.blockStates,  &w.baseTriangles, &w.blockList, &w.obsoleteTriangles,
          &w.blockSums,  &w.insideBits,   &w.rows,          &w.rowSums,   &w.cases,
          &w.edgeList,   &w.triangleList, &w.vertices,      &w.indices,   &w.commands})
        sum += buffer->bytes();
    if (w.peaks) sum += w.peaks->volume.bytes() + w.peaks->splatted.bytes() + w.peaks->vertices.bytes();
    if (w.freezing) sum += w.freezing->volume.bytes() + w.freezing->splatted.bytes() + w.freezing->vertices.bytes();
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
