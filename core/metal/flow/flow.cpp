#include "core/metal/flow/flow.hpp"

#include "core/base/error.hpp"
#include "core/gl/order.hpp"
#include "shaders/shared/dispatch.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>

namespace meltpool {

namespace {

// Neighbour lists (Verlet 1967) reach a little beyond the support and hold until two neighbours may have moved some way
// relative to each other. The way is summed from the fastest neighbour of each substep, whichever it is, so that nearly
// all move much less: two drops that collide miss pairs worth 3e-7 of the density on average and 3e-4 at most.
constexpr double kSkin = 0.1;    // spacings beyond the support
constexpr double kFreeWay = 0.5; // spacings
constexpr GLbitfield kBarrier = GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT;
constexpr unsigned kChangeGroups =
    8; // groups of passes over changes, whose number the CPU does not know: each invocation handles several
constexpr unsigned kMostChangeGroups = 1024;
/// Substeps after which an unfinished step checks its buffers' capacity again, and waits for the GPU. Steps of a frame
/// have fewer.
constexpr unsigned kSubstepsInRoom = 64;

size_t cellCount(const FlowBlock& block) {
    return static_cast<size_t>(block.cells.x) * static_cast<size_t>(block.cells.y) * static_cast<size_t>(block.cells.z);
}

/// Writes the wetting of wall metal.
void setWettingOf(FlowBlock& block, const FlowFluid& fluid) {
    block.hotWetting = static_cast<float>(fluid.wetting);
    block.coldWetting = static_cast<float>(fluid.coldWetting);
    block.coldBelow = static_cast<float>(fluid.coldBelow);
    block.inverseWettingRange = static_cast<float>(1 / std::max(fluid.warmAbove - fluid.coldBelow, 1.0));
}

/// Writes the constants that follow from the liquid's properties.
void setLiquid(FlowBlock& block, const FlowConstants& constants, const FlowFluid& fluid) {
    block.kernelSelf = static_cast<float>(constants.kernelSelf);
    block.soundSpeedSquared = static_cast<float>(constants.soundSpeed * constants.soundSpeed);
    block.pairFriction = static_cast<float>(constants.friction);
    block.mushyDrag = static_cast<float>(constants.mushyDrag);
    block.cohesion = static_cast<float>(constants.cohesion);
    block.areaForce = static_cast<float>(constants.area);
    const TensionSlopes& slopes = fluid.tensionSlopes;
    static_assert(std::tuple_size_v<decltype(TensionSlopes::values)> == FLOW_TENSION_SLOPES);
    block.firstSlopeAt = static_cast<float>(slopes.from);
    block.inverseSlopeStep = static_cast<float>(1 / slopes.step);
    for (int i = 0; i < FLOW_TENSION_SLOPES; ++i)
        block.tensionSlopes[i / 4][i % 4] = static_cast<float>(slopes.values[static_cast<size_t>(i)] / fluid.density);
    block.wallFriction = static_cast<float>(constants.wallFriction);
    block.densityScale = static_cast<float>(constants.scale);
    setWettingOf(block, fluid);
    block.expansion = static_cast<float>(fluid.expansion);
    block.referenceTemperature = static_cast<float>(fluid.referenceTemperature);
}

FlowBlock makeBlock(const FlowConstants& constants, const FlowFluid& fluid, const FlowSpace& space, size_t capacity) {
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
    if (fluid.tensionSlopes.any()) defines["MARANGONI"] = "1";
    return defines;
}

unsigned groupsOf(size_t invocations) {
    return static_cast<unsigned>((invocations + GROUP_SIZE - 1) / GROUP_SIZE);
}

gl::Buffer makeLists(size_t capacity) {
    return gl::Buffer::gpuOnly("flow lists", (2 * capacity + FLOW_STALE_CAPACITY) * sizeof(uint));
}

} // namespace

Flow::Flow(gl::ShaderLibrary& shaders, MetalState& state, const FlowFluid& fluid, const FlowSpace& space)
    : state_(state),
      constants_(FlowConstants::of(fluid)),
      restDensity_(fluid.density),
      block_(makeBlock(constants_, fluid, space, state.capacity())),
      first_(block_),
      classify_(shaders.compute("metal/flow/classify.comp", definesOf(space))),
      compact_(shaders.compute("metal/flow/compact.comp", definesOf(space))),
      bin_(shaders.compute("metal/flow/bin.comp", definesOf(space))),
      sort_(shaders.compute("metal/flow/sort.comp", definesOf(space))),
      search_(shaders.compute("metal/flow/search.comp", definesOf(space))),
      boundary_(shaders.compute("metal/flow/boundary.comp", definesOf(space))),
      density_(shaders.compute("metal/flow/density.comp", definesOf(space))),
      move_(shaders.compute("metal/flow/move.comp", definesOf(fluid, space))),
      xorOutDerived_(shaders.compute("metal/flow/xor_out_derived.comp", definesOf(space))),
      blockBuffer_("flow block", sizeof(FlowBlock)),
      particles_(gl::Buffer::gpuOnly("flow particles", state.capacity() * sizeof(FlowParticle))),
      cells_(gl::Buffer::gpuOnly("flow cells", block_.cellCount * sizeof(FlowCell))),
      nextInCell_(gl::Buffer::gpuOnly("flow next in cell", state.capacity() * sizeof(uint))),
      lists_(makeLists(state.capacity())),
      counters_(gl::Buffer::gpuOnly("flow counters", sizeof(FlowCounters))),
      changed_(gl::Buffer::gpuOnly("flow changed cells, slots", (block_.cellCount + FLOW_WALL_CHANGES) * sizeof(uint))),
      wallSums_(gl::Buffer::gpuOnly("flow wall sums", state.capacity() * sizeof(ivec4))),
      cellTexels_("flow cell texels", cells_, GL_RGBA32UI, sizeof(uvec4)) {
    makeTexels();
}

void Flow::makeTexels() {
    positionTexels_ = gl::BufferView("flow position texels", state_.position, GL_RGBA32F, sizeof(vec4));
    particleTexels_ = gl::BufferView("flow particle texels", particles_, GL_RGBA32F, sizeof(vec4));
}

void Flow::onCapacityChanged() {
    const auto before = static_cast<size_t>(block_.capacity);
    const size_t capacity = state_.capacity();
    particles_.resize(capacity * sizeof(FlowParticle));
    nextInCell_.resize(capacity * sizeof(uint));
    wallSums_.resize(capacity * sizeof(ivec4));
    makeTexels();
    block_.capacity = static_cast<int>(capacity);
    blockChanged_ = true;
    moveLists(before);
    capacity_.setSlots(capacity);
}

/// Moves the fragments' list to the new end of the slots, see flow/common.glsl. Between two steps only the lists of
/// moving metal hold.
void Flow::moveLists(size_t before) {
    const auto capacity = static_cast<size_t>(block_.capacity);
    const FlowCounters counters = counters_.read<FlowCounters>(1)[0];
    const size_t liquids = counters.liquids * sizeof(uint), fragments = counters.fragments * sizeof(uint);
    auto lists = makeLists(capacity);
    if (liquids + fragments <= std::min(before, capacity) * sizeof(uint)) {
        lists_.copyTo(lists, liquids);
        lists_.copyTo(lists, fragments, before * sizeof(uint) - fragments, capacity * sizeof(uint) - fragments);
    }
    lists_ = std::move(lists);
}

/// Keeps the grown capacity of lists and pages: spare capacity changes no result.
void Flow::reset() {
    for (const gl::Buffer* buffer : {&particles_, &cells_, &nextInCell_, &lists_, &counters_, &changed_, &wallSums_})
        buffer->clear();
    tables_.clear();
    FlowBlock block = first_;
    block.capacity = block_.capacity;
    block.rowCapacity = block_.rowCapacity;
    block.wallPageCapacity = block_.wallPageCapacity;
    block.movingPageCapacity = block_.movingPageCapacity;
    block_ = block;
    blockChanged_ = true;
    known_ = 0;
    regroupings_ = 0;
}

/// `waits`: reads the present use, instead of that of some steps ago.
void Flow::growLists(bool waits) {
    if (known_ == 0) capacity_.start(state_, block_);
    if (waits) capacity_.readNow(state_.particles(), counters_);
    capacity_.update(state_.particles(), counters_);
    if (!FlowTables::fits(capacity_, block_)) {
        blockChanged_ = true;
        tables_.fit(capacity_, block_);
    }
    bind();
}

void Flow::bind() {
    if (blockChanged_) blockBuffer_.writeValue(block_);
    blockChanged_ = false;
    state_.bind();
    blockBuffer_.bindUniform(FLOW_BLOCK);
    particles_.bindStorage(FLOW_PARTICLES);
    cells_.bindStorage(FLOW_CELLS);
    nextInCell_.bindStorage(FLOW_NEXT_IN_CELL);
    lists_.bindStorage(FLOW_LISTS);
    counters_.bindStorage(FLOW_COUNTERS);
    changed_.bindStorage(FLOW_CHANGED);
    wallSums_.bindStorage(FLOW_WALL_SUMS);
    state_.changes.bindStorage(FLOW_PHASE_CHANGES);
    positionTexels_.bind(FLOW_TEXELS_POSITIONS);
    particleTexels_.bind(FLOW_TEXELS_PARTICLES);
    cellTexels_.bind(FLOW_TEXELS_CELLS);
    tables_.bind();
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
    block_.arcShear = static_cast<float>(static_cast<double>(arc.shear) / restDensity_);
    block_.inverseArcSigma = 1 / arc.sigma;
    blockChanged_ = true;
}

void Flow::setWetting(const FlowFluid& fluid) {
    setWettingOf(block_, fluid);
    blockChanged_ = true;
}

void Flow::step(double seconds, gl::Profiler* profiler) {
    step(seconds, constants_.substeps(seconds), profiler);
}

void Flow::step(double seconds, unsigned substeps, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "flow");
    const double dt = seconds / substeps;
    if (block_.timeStep != static_cast<float>(dt)) {
        block_.timeStep = static_cast<float>(dt);
        // Limits the speed so that no particle crosses more than a third of a support in a substep: faster metal would
        // pass through walls.
        block_.speedLimit = static_cast<float>(constants_.support / (3 * dt));
        blockChanged_ = true;
    }
    for (unsigned done = 0; done < substeps; ++done) {
        if (done % kSubstepsInRoom == 0) growLists(done > 0);
        if (done == 0) updateGroups(profiler);
        substep(profiler);
    }
    capacity_.request(state_.particles(), counters_);
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
    gl::memoryBarrier(kBarrier);
    compact_.dispatchGroups(kChangeGroups);
    gl::memoryBarrier(kBarrier);
    bin_.dispatchGroups(kChangeGroups);
    gl::memoryBarrier(kBarrier);
}

void Flow::substep(gl::Profiler* profiler) {
    const auto pass = [&](const gl::Program& program, const char* name, size_t groups) {
        const gl::Scope scope(profiler, name);
        program.dispatchIndirect(groups);
        gl::memoryBarrier(kBarrier);
    };
    pass(sort_, "flow sort", offsetof(FlowCounters, searchGroups));
    pass(search_, "flow search", offsetof(FlowCounters, listGroups));
    pass(boundary_, "flow boundary", offsetof(FlowCounters, boundaryGroups));
    pass(density_, "flow density", offsetof(FlowCounters, densityGroups));
    pass(move_, "flow move", offsetof(FlowCounters, movingGroups));
}

FlowFaults Flow::readFaults() const {
    const FlowCounters counters = counters_.read<FlowCounters>(1)[0];
    return {counters.cellsOverfull, counters.neighboursOverfull, counters.notFinite, counters.listsOverfull};
}

unsigned Flow::readMoving() const {
    const FlowCounters counters = counters_.read<FlowCounters>(1)[0];
    return counters.liquids + counters.fragments;
}

unsigned Flow::readSearches() const {
    return counters_.read<FlowCounters>(1)[0].searches;
}

std::vector<FlowParticle> Flow::readParticles() const {
    return particles_.read<FlowParticle>(state_.particles());
}

size_t Flow::bytes() const {
    size_t sum = tables_.bytes();
    for (const gl::Buffer* buffer :
         {&blockBuffer_, &particles_, &cells_, &nextInCell_, &lists_, &counters_, &changed_, &wallSums_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
