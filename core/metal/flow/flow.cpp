#include "core/metal/flow/flow.hpp"

#include "core/base/error.hpp"
#include "shaders/shared/dispatch.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>

namespace meltpool {

namespace {

// Neighbour lists (Verlet 1967) reach a little beyond the support and hold until two neighbours may have gone some way
// against each other. The way is summed from the fastest neighbour of each substep, whichever it is, so that nearly all
// go much less: two drops that collide miss pairs worth 3e-7 of the density on average and 3e-4 at most.
constexpr double kSkin = 0.1;    // spacings beyond the support
constexpr double kFreeWay = 0.5; // spacings
constexpr GLbitfield kBarrier = GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT;
constexpr unsigned kChangeGroups =
    8; // of passes over what changed, whose number the CPU does not know: each invocation does several
constexpr unsigned kMostChangeGroups = 1024;

size_t cellCount(const FlowBlock& block) {
    return static_cast<size_t>(block.cells.x) * static_cast<size_t>(block.cells.y) * static_cast<size_t>(block.cells.z);
}

/// What follows from the liquid's properties.
void setLiquid(FlowBlock& block, const FlowConstants& constants, const FlowFluid& fluid) {
    block.kernelSelf = static_cast<float>(constants.kernelSelf);
    block.soundSpeedSquared = static_cast<float>(constants.soundSpeed * constants.soundSpeed);
    block.pairFriction = static_cast<float>(constants.friction);
    block.mushyDrag = static_cast<float>(constants.mushyDrag);
    block.cohesion = static_cast<float>(constants.cohesion);
    block.areaForce = static_cast<float>(constants.area);
    block.marangoni = static_cast<float>(fluid.tensionSlope / fluid.density);
    block.wallFriction = static_cast<float>(constants.wallFriction);
    block.densityScale = static_cast<float>(constants.scale);
    block.hotWetting = static_cast<float>(fluid.wetting);
    block.coldWetting = static_cast<float>(fluid.coldWetting);
    block.coldBelow = static_cast<float>(fluid.coldBelow);
    block.inverseWettingRange = static_cast<float>(1 / std::max(fluid.warmAbove - fluid.coldBelow, 1.0));
    block.expansion = static_cast<float>(fluid.expansion);
    block.referenceTemperature = static_cast<float>(fluid.referenceTemperature);
}

FlowBlock makeBlock(const FlowConstants& constants, const FlowFluid& fluid, const FlowSpace& space, size_t capacity,
                    size_t listCapacity) {
    FlowBlock block{};
    const auto reach = static_cast<float>(constants.support + kSkin * fluid.spacing);
    const glm::vec3 size = space.high - space.low;
    for (int axis = 0; axis < 3; ++axis) {
        block.cells[axis] = std::max(1, static_cast<int>(size[axis] / reach * (1 + 1e-5F)));
        block.inverseCellSize[axis] = static_cast<float>(block.cells[axis]) / size[axis];
        if (!space.repeats[axis]) continue;
        if (block.cells[axis] < 3) throw RuntimeFault("a repeating space must be at least three kernel supports long");
        block.period[axis] = size[axis];
        block.inversePeriod[axis] = 1 / size[axis];
    }
    block.origin = space.low;
    block.support = static_cast<float>(constants.support);
    block.inverseSupport = 1 / block.support;
    block.high = space.high;
    block.halfSpacing = static_cast<float>(0.5 * fluid.spacing);
    block.capacity = static_cast<int>(capacity);
    block.listCapacity = static_cast<uint>(listCapacity);
    block.cellCount = static_cast<uint>(cellCount(block));
    block.acceleration = space.acceleration;
    block.reach = reach;
    block.freeWay = static_cast<float>(kFreeWay * fluid.spacing);
    setLiquid(block, constants, fluid);
    return block;
}

gl::Defines definesOf(const FlowSpace& space) {
    gl::Defines defines;
    if (glm::any(space.repeats)) defines["REPEATS"] = "1";
    return defines;
}

gl::Defines definesOf(const FlowFluid& fluid, const FlowSpace& space) {
    gl::Defines defines = definesOf(space);
    if (fluid.tensionSlope != 0) defines["MARANGONI"] = "1";
    return defines;
}

size_t neighbourEntries(size_t room) {
    return (2 * room + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE * FLOW_NEIGHBOUR_CAPACITY;
}

unsigned groupsOf(size_t invocations) {
    return static_cast<unsigned>((invocations + GROUP_SIZE - 1) / GROUP_SIZE);
}

} // namespace

Flow::Flow(gl::ShaderLibrary& shaders, MetalState& state, const FlowFluid& fluid, const FlowSpace& space,
           size_t mostMoving)
    : state_(state),
      constants_(FlowConstants::of(fluid)),
      restDensity_(fluid.density),
      block_(makeBlock(constants_, fluid, space, state.capacity(),
                       mostMoving == 0 ? state.capacity() : std::min(mostMoving, state.capacity()))),
      classify_(shaders.compute("metal/flow/classify.comp", definesOf(space))),
      compact_(shaders.compute("metal/flow/compact.comp", definesOf(space))),
      bin_(shaders.compute("metal/flow/bin.comp", definesOf(space))),
      sort_(shaders.compute("metal/flow/sort.comp", definesOf(space))),
      search_(shaders.compute("metal/flow/search.comp", definesOf(space))),
      boundary_(shaders.compute("metal/flow/boundary.comp", definesOf(space))),
      density_(shaders.compute("metal/flow/density.comp", definesOf(space))),
      move_(shaders.compute("metal/flow/move.comp", definesOf(fluid, space))),
      blockBuffer_("flow block", sizeof(FlowBlock)),
      particles_("flow particles", state.capacity() * sizeof(FlowParticle)),
      cells_("flow cells", cellCount(block_) * sizeof(FlowCell)),
      cellLists_("flow cell lists", cellCount(block_) * 4 * FLOW_CELL_CAPACITY * sizeof(uint)),
      binned_("flow binned slots", cellCount(block_) * FLOW_CELL_CAPACITY * sizeof(uint)),
      lists_("flow lists", (size_t(5) * block_.listCapacity + FLOW_STALE_CAPACITY) * sizeof(uint)),
      neighbours_("flow neighbours", neighbourEntries(block_.listCapacity) * sizeof(uint)),
      counters_("flow counters", sizeof(FlowCounters)),
      changed_("flow changed cells, slots", (cellCount(block_) + FLOW_WALL_CHANGES) * sizeof(uint)),
      wallSums_("flow wall sums", state.capacity() * sizeof(ivec4)),
      positionTexels_("flow position texels", state.position, GL_RGBA32F, sizeof(vec4)),
      particleTexels_("flow particle texels", particles_, GL_RGBA32F, sizeof(vec4)),
      neighbourTexels_("flow neighbour texels", neighbours_, GL_R32UI, sizeof(uint)),
      cellTexels_("flow cell texels", cells_, GL_RGBA32UI, sizeof(FlowCell)),
      cellSlotTexels_("flow cell slot texels", cellLists_, GL_R32UI, sizeof(uint)),
      cellPositionTexels_("flow cell position texels", cellLists_, GL_RGBA32UI, sizeof(uvec4)) {}

void Flow::bind() const {
    state_.bind();
    blockBuffer_.bindUniform(FLOW_BLOCK);
    particles_.bindStorage(FLOW_PARTICLES);
    cells_.bindStorage(FLOW_CELLS);
    cellLists_.bindStorage(FLOW_CELL_LISTS);
    binned_.bindStorage(FLOW_BINNED);
    lists_.bindStorage(FLOW_LISTS);
    neighbours_.bindStorage(FLOW_NEIGHBOURS);
    counters_.bindStorage(FLOW_COUNTERS);
    changed_.bindStorage(FLOW_CHANGED);
    wallSums_.bindStorage(FLOW_WALL_SUMS);
    state_.changes.bindStorage(FLOW_PHASE_CHANGES);
    positionTexels_.bind(FLOW_TEXELS_POSITIONS);
    particleTexels_.bind(FLOW_TEXELS_PARTICLES);
    neighbourTexels_.bind(FLOW_TEXELS_NEIGHBOURS);
    cellTexels_.bind(FLOW_TEXELS_CELLS);
    cellSlotTexels_.bind(FLOW_TEXELS_CELL_SLOTS);
    cellPositionTexels_.bind(FLOW_TEXELS_CELL_POSITIONS);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, counters_.name());
}

void Flow::setAcceleration(glm::vec3 acceleration) {
    block_.acceleration = acceleration;
    blockChanged_ = true;
}

void Flow::setArc(const ArcPressure& arc) {
    block_.arcCentre = arc.place;
    block_.arcInverseVariance = 1 / (2 * arc.sigma * arc.sigma);
    block_.arcAxis = arc.axis;
    block_.arcPeak = static_cast<float>(static_cast<double>(arc.peak) / restDensity_);
    blockChanged_ = true;
}

void Flow::step(double seconds, gl::Profiler* profiler) {
    step(seconds, constants_.substeps(seconds), profiler);
}

void Flow::step(double seconds, unsigned substeps, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "flow");
    const double dt = seconds / substeps;
    const auto stepLength = static_cast<float>(dt);
    if (blockChanged_ || block_.timeStep != stepLength) {
        block_.timeStep = stepLength;
        // Nothing may cross more than a third of a support in a substep: faster metal would pass through walls.
        block_.speedLimit = static_cast<float>(constants_.support / (3 * dt));
        blockBuffer_.writeValue(block_);
        blockChanged_ = false;
    }
    bind();
    updateGroups(profiler);
    for (unsigned i = 0; i < substeps; ++i)
        substep(profiler);
}

void Flow::updateGroups(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "flow changes");
    const bool regrouped = regroupings_ != state_.regroupings();
    regroupings_ = state_.regroupings();
    const size_t known = regrouped ? 0 : known_;
    known_ = state_.particles();
    classify_.set("known", static_cast<unsigned>(known));
    classify_.set("slots", static_cast<unsigned>(known_));
    classify_.dispatchGroups(std::clamp(groupsOf(known_ - known), kChangeGroups, kMostChangeGroups));
    glMemoryBarrier(kBarrier);
    compact_.dispatchGroups(kChangeGroups);
    glMemoryBarrier(kBarrier);
    bin_.dispatchGroups(kChangeGroups);
    glMemoryBarrier(kBarrier);
}

void Flow::substep(gl::Profiler* profiler) {
    const auto pass = [&](const gl::Program& program, const char* name, size_t groups) {
        const gl::Scope scope(profiler, name);
        program.dispatchIndirect(groups);
        glMemoryBarrier(kBarrier);
    };
    pass(sort_, "flow sort", offsetof(FlowCounters, searchGroups));
    pass(search_, "flow search", offsetof(FlowCounters, searchGroups));
    pass(boundary_, "flow boundary", offsetof(FlowCounters, boundaryGroups));
    pass(density_, "flow density", offsetof(FlowCounters, densityGroups));
    pass(move_, "flow move", offsetof(FlowCounters, movingGroups));
}

FlowFaults Flow::readFaults() const {
    const FlowCounters counters = counters_.read<FlowCounters>(1)[0];
    return {counters.cellsOverfull, counters.neighboursOverfull, counters.notFinite, counters.listsOverfull};
}

unsigned Flow::readMoving() const {
    return counters_.read<FlowCounters>(1)[0].moving;
}

unsigned Flow::readSearches() const {
    return counters_.read<FlowCounters>(1)[0].searches;
}

std::vector<FlowParticle> Flow::readParticles() const {
    return particles_.read<FlowParticle>(state_.particles());
}

size_t Flow::bytes() const {
    size_t sum = 0;
    for (const gl::Buffer* buffer : {&blockBuffer_, &particles_, &cells_, &cellLists_, &binned_, &lists_, &neighbours_,
                                     &counters_, &changed_, &wallSums_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
