#include "core/metal/classic/classic_metal.hpp"

#include "core/base/error.hpp"
#include "core/base/hash.hpp"
#include "core/gl/order.hpp"
#include "core/metal/classic/arrangement.hpp"
#include "core/metal/classic/classic_kernels.hpp"
#include "shaders/shared/classic.h"
#include "shaders/shared/dispatch.h"

#include <numeric>
#include <string>

namespace meltpool {

namespace {

size_t checkedCount(const ClassicSetup& setup) {
    if (setup.particles < 1) throw InputError("the classic metal has no particles; expected at least 1");
    return static_cast<size_t>(setup.particles);
}

gl::Buffer vectors(const char* label, size_t count) {
    return {label, count * sizeof(vec4)};
}

} // namespace

ClassicMetal::ClassicMetal(gl::ShaderLibrary& library, const ClassicSetup& setup)
    : setup_(setup),
      count_(checkedCount(setup)),
      stepBlock_("classic step", sizeof(ClassicStep)),
      movedPositions_(vectors("classic positions", count_)),
      movedVelocities_(vectors("classic velocities", count_)),
      movedNumbers_("classic numbers", count_ * sizeof(uint)),
      sortedPositions_(vectors("classic sorted positions", count_)),
      sortedVelocities_(vectors("classic sorted velocities", count_)),
      sortedNumbers_("classic sorted numbers", count_ * sizeof(uint)),
      refused_("classic refused states", sizeof(uint)),
      positionTexels_("classic position texels", sortedPositions_, GL_RGBA32F, sizeof(vec4)),
      velocityTexels_("classic velocity texels", sortedVelocities_, GL_RGBA32F, sizeof(vec4)),
      order_(library, count_),
      reader_(library, count_),
      grid_{library.compute("metal/classic/density.comp"), library.compute("metal/classic/move.comp")},
      pairs_{library.compute("metal/classic/density.comp", {{"ALL_PAIRS", "1"}}),
             library.compute("metal/classic/move.comp", {{"ALL_PAIRS", "1"}})} {
    reset();
}

void ClassicMetal::reset() {
    restore({arrangeParticles(setup_), std::vector<glm::vec4>(count_, glm::vec4(0))});
    refused_.clear();
    reader_.discard();
    writeStep({}); // allows statistics() before the first step
}

void ClassicMetal::restore(const Snapshot& state) {
    if (state.positions.size() != count_ || state.velocities.size() != count_)
        throw RuntimeFault("the state has " + std::to_string(state.positions.size()) + " positions and " +
                           std::to_string(state.velocities.size()) + " velocities; expected " + std::to_string(count_) +
                           " of each");
    std::vector<uint> numbers(count_);
    std::iota(numbers.begin(), numbers.end(), 0U);
    movedPositions_.write(std::span<const glm::vec4>(state.positions));
    movedVelocities_.write(std::span<const glm::vec4>(state.velocities));
    movedNumbers_.write(std::span<const uint>(numbers));
    order_.discardCounts();
}

ClassicMetal::Snapshot ClassicMetal::snapshot() const {
    const auto positions = movedPositions_.read<glm::vec4>(count_);
    const auto velocities = movedVelocities_.read<glm::vec4>(count_);
    const auto numbers = movedNumbers_.read<uint>(count_);
    Snapshot state{std::vector<glm::vec4>(count_), std::vector<glm::vec4>(count_)};
    for (size_t slot = 0; slot < count_; ++slot) {
        state.positions.at(numbers[slot]) = positions[slot];
        state.velocities.at(numbers[slot]) = velocities[slot];
    }
    return state;
}

/// Omits the order of the slots, which changes no sum: particles of a cell are sorted by number.
void ClassicMetal::transfer(gl::StateArchive& archive) {
    archive.rows(movedPositions_, count_, sizeof(vec4));
    archive.rows(movedVelocities_, count_, sizeof(vec4));
    archive.list(movedNumbers_, count_ * sizeof(uint));
    archive.buffer(refused_, sizeof(uint));
    if (!archive.restores()) return;
    order_.discardCounts();
    reader_.discard();
}

void ClassicMetal::writeStep(const ClassicSource& source) {
    const ClassicParameters& p = parameters;
    const ClassicKernels kernels(static_cast<double>(p.supportRadius));
    const CellGrid& grid = order_.grid();
    ClassicStep step{};
    step.gravity = p.gravity;
    step.source = source.position;
    step.heatRadiusSquared = p.heatRadius;
    step.heat = source.strength * p.heatTemperature * (source.cold ? -1.0F : 1.0F);
    step.solidifyRate = p.solidifyRate;
    step.restDensity = p.restDensity;
    step.gasStiffness = p.gasStiffness;
    step.supportRadius = p.supportRadius;
    step.poly6 = static_cast<float>(static_cast<double>(p.particleMass) * kernels.poly6Factor);
    step.spiky = static_cast<float>(static_cast<double>(p.particleMass) * kernels.spikyFactor);
    step.viscosity = p.viscosity * step.spiky; // factor 45 / (pi h^6) of both kernels
    step.timeStep = p.timeStep;
    step.wallRestitution = p.wallRestitution;
    step.accelerationLimit = p.accelerationLimit;
    step.cellsPerUnit = grid.cellsPerUnit;
    step.particles = static_cast<uint>(count_);
    step.cellsPerAxis = grid.perAxis;
    step.wallSlip = p.wallSlip ? 1U : 0U;
    stepBlock_.writeValue(step);
}

void ClassicMetal::bindState() const {
    stepBlock_.bindUniform(CLASSIC_STEP);
    movedPositions_.bindStorage(CLASSIC_MOVED_POSITIONS);
    movedVelocities_.bindStorage(CLASSIC_MOVED_VELOCITIES);
    movedNumbers_.bindStorage(CLASSIC_MOVED_NUMBERS);
    sortedPositions_.bindStorage(CLASSIC_SORTED_POSITIONS);
    sortedVelocities_.bindStorage(CLASSIC_SORTED_VELOCITIES);
    sortedNumbers_.bindStorage(CLASSIC_SORTED_NUMBERS);
    refused_.bindStorage(CLASSIC_REFUSED);
    positionTexels_.bind(CLASSIC_POSITION_TEXELS);
    velocityTexels_.bind(CLASSIC_VELOCITY_TEXELS);
    order_.bind();
}

void ClassicMetal::step(const ClassicSource& source, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "classic step");
    const CellGrid grid = CellGrid::forRadius(parameters.supportRadius, count_);
    if (!(grid == order_.grid())) order_.setGrid(grid);
    writeStep(source);
    bindState();
    if (allPairs_)
        keepOrder();
    else
        sortByCell(profiler);
    computeDensity(profiler);
    moveParticles(profiler);
}

/// Reads the moved state, writes the sorted one.
void ClassicMetal::sortByCell(gl::Profiler* profiler) {
    order_.sort(profiler);
    std::swap(movedNumbers_, sortedNumbers_); // moving does not change the order
}

void ClassicMetal::keepOrder() {
    movedPositions_.copyTo(sortedPositions_, count_ * sizeof(vec4));
    movedVelocities_.copyTo(sortedVelocities_, count_ * sizeof(vec4));
    order_.discardCounts();
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// Reads sorted positions; writes 1 / density into the fourth component of the sorted velocities, and the neighbours
/// into the moved state, which is free until the next pass.
void ClassicMetal::computeDensity(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "classic density");
    (allPairs_ ? pairs_ : grid_).density.dispatch(count_, GROUP_SIZE);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// Reads the sorted state, writes the moved one and counts it for the next sort.
void ClassicMetal::moveParticles(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "classic move");
    (allPairs_ ? pairs_ : grid_).move.dispatch(count_, GROUP_SIZE);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                      GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

MetalStatistics ClassicMetal::statistics() const {
    bindState();
    return reader_.now(refused_);
}

void ClassicMetal::requestStatistics() {
    bindState();
    reader_.request(refused_);
}

std::uint64_t ClassicMetal::stateHash() const {
    const Snapshot state = snapshot();
    StateHash hash;
    for (size_t i = 0; i < count_; ++i) {
        hash.add(std::span<const float>(&state.positions[i].x, 4));
        hash.add(std::span<const float>(&state.velocities[i].x, 3));
    }
    return hash.value();
}

size_t ClassicMetal::bytes() const {
    size_t sum = order_.bytes() + reader_.bytes();
    for (const gl::Buffer* buffer : {&stepBlock_, &movedPositions_, &movedVelocities_, &movedNumbers_,
                                     &sortedPositions_, &sortedVelocities_, &sortedNumbers_, &refused_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
