#include "core/surface/surface.hpp"

#include "core/base/error.hpp"
#include "core/gl/readback.hpp"
#include "core/metal/state/metal_state.hpp"
#include "core/surface/surface_mesher.hpp"
#include "core/surface/surface_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

SurfaceStatistics statisticsOf(const SurfaceCommands& commands) {
    return {commands.vertexCount,   commands.triangleCount, commands.blockCount,
            commands.splattedCount, commands.rebuilt != 0,  commands.overflow != 0};
}

/// Share of the solidus in K up to which metal of the lattice counts as unmoved: hotter metal has neighbours that
/// melted. No source: chosen; at the toe of a bead on steel it is 2 mm.
constexpr float kFlatBelow = 0.65F;

/// Returns the integer for a weight of 1 in the freezing volume: the wider a particle reaches, the more of them meet in
/// a corner, whose sum of at most one particle a cell must not exceed 4096.
float freezingUnit(int influence) {
    constexpr float kFinest = 64, kCoarsest = 4, kInReach = 8000;
    const auto across = static_cast<float>(2 * influence - 1);
    return std::clamp(std::floor(kInReach / (across * across * across)), kCoarsest, kFinest);
}

} // namespace

/// Data shared by volumes and mesher: the grid, the setup of an update, and the sizes that the GPU decides.
struct Surface::Work {
    Work(gl::ShaderLibrary& shaders, const SurfaceGrid& theGrid)
        : grid(theGrid),
          setup(grid.setup()),
          setupBlock("surface setup", sizeof(SurfaceSetup)),
          commands("surface commands", sizeof(SurfaceCommands)),
          volumes(shaders, grid, commands),
          mesher(shaders, grid, commands),
          readback("surface counts", sizeof(SurfaceCommands)) {
        SurfaceCommands start{};
        start.changed = {0, 1, 1};
        commands.writeValue(start);
        setupBlock.writeValue(setup); // the volumes can be queried before the first update
    }

    SurfaceGrid grid;
    SurfaceSetup setup;
    SurfaceParameters used; ///< parameters that the volumes were made with
    gl::Buffer setupBlock, commands;
    SurfaceVolumes volumes;
    SurfaceMesher mesher;
    gl::Readback readback;
};

Surface::Surface(gl::ShaderLibrary& shaders, const SurfaceParameters& wanted, glm::vec3 boxMin, glm::vec3 boxMax)
    : parameters(wanted), work_(std::make_unique<Work>(shaders, SurfaceGrid(wanted.cells, boxMin, boxMax))) {}

Surface::~Surface() = default;

void Surface::setTemperatureRange(float coldest, float hottest) {
    if (!(hottest > coldest)) throw InputError("the surface's temperature range is empty; expected coldest < hottest");
    SurfaceSetup& setup = work_->setup;
    if (setup.coldest == coldest && setup.temperatureRange == hottest - coldest) return;
    setup.coldest = coldest;
    setup.temperatureRange = hottest - coldest;
    work_->volumes.forget();
}

bool Surface::mustRebuild(const ParticleView& particles) const {
    const SurfaceParameters& used = work_->used;
    return !incremental.enabled || !work_->volumes.canFollow(particles) || used.influence != parameters.influence ||
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
    setup.particleData = work_->volumes.particleData();
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
    if (incremental.enabled) w.volumes.growParticleBuffers(particles.count);
    const bool rebuild = mustRebuild(particles);
    w.used = parameters;
    w.used.kernel = std::clamp(parameters.kernel, 0, 1);
    w.volumes.take(particles, incremental.enabled);
    w.mesher.take(w.volumes.particleData());
    writeSetup(particles, rebuild);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, w.commands.name());
    if (rebuild) {
        const gl::Scope scope(profiler, "surface clear");
        w.mesher.clear();
        w.volumes.clear();
    }
    {
        const gl::Scope scope(profiler, "surface splat");
        if (rebuild)
            w.volumes.splatAll(particles, w.used.kernel);
        else
            w.volumes.splatChanged(particles, w.used.kernel);
    }
    w.mesher.update(w.volumes, w.setup, profiler);
}

SurfaceMesh Surface::mesh() const {
    return work_->mesher.mesh(work_->volumes.particleData());
}

const SurfaceGrid& Surface::grid() const {
    return work_->grid;
}

const gl::Buffer& Surface::densityVolume() const {
    return work_->volumes.density();
}

const gl::Buffer& Surface::temperatureVolume() const {
    return work_->volumes.temperature();
}

const gl::Buffer* Surface::freezingVolume() const {
    return work_->volumes.freezing();
}

void Surface::bindVolumes() const {
    work_->setupBlock.bindUniform(SURFACE_BIND_SETUP);
    work_->volumes.density().bindStorage(SURFACE_BIND_DENSITY);
    work_->volumes.temperature().bindStorage(SURFACE_BIND_TEMPERATURE);
}

size_t Surface::bytes() const {
    const Work& w = *work_;
    return w.setupBlock.bytes() + w.commands.bytes() + w.volumes.bytes() + w.mesher.bytes();
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
