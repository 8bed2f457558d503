#include "core/metal/flow/flow.hpp"

#include "core/base/error.hpp"
#include "shaders/shared/dispatch.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>

namespace meltpool {

namespace {

// Neighbour lists reach a little beyond the support and serve until two neighbours may have gone some way against each
// other. The way is summed up from the fastest of all neighbours, whichever it is, so that nearly all go much less: two
// drops that collide miss pairs worth 3e-7 of the density on average and 3e-4 at most.
constexpr double kSkin = 0.1;    // spacings beyond the support
constexpr double kFreeWay = 0.5; // spacings
constexpr GLbitfield kBarrier = GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT;
constexpr unsigned kTidyGroups = 8; // passes over what changed stride over it: few groups, no arguments to prepare
constexpr unsigned kMostGroups = 1024;

size_t cellCount(const FlowBlock& block) {
    return static_cast<size_t>(block.cells.x) * static_cast<size_t>(block.cells.y) * static_cast<size_t>(block.cells.z);
}

FlowBlock makeBlock(const FlowConstants& constants, const FlowFluid& fluid, const FlowSpace& space, size_t capacity,
                    size_t room) {
    FlowBlock block{};
    const auto support = static_cast<float>(constants.support);
    const auto reach = static_cast<float>(constants.support + kSkin * fluid.spacing);
    const glm::vec3 size = space.high - space.low;
    glm::ivec3 cells(0);
    glm::vec3 inverseCell(0), period(0), inversePeriod(0);
    for (int axis = 0; axis < 3; ++axis) {
        cells[axis] = std::max(1, static_cast<int>(size[axis] / reach * (1 + 1e-5F)));
        inverseCell[axis] = static_cast<float>(cells[axis]) / size[axis];
        if (!space.repeats[axis]) continue;
        if (cells[axis] < 3) throw RuntimeFault("a repeating space must be at least three kernel supports long");
        period[axis] = size[axis];
        inversePeriod[axis] = 1 / size[axis];
    }
    block.origin = vec4(space.low, support);
    block.inverseCell = vec4(inverseCell, 1 / support);
    block.period = vec4(period, 0);
    block.inversePeriod = vec4(inversePeriod, 0);
    block.high = vec4(space.high, static_cast<float>(0.5 * fluid.spacing));
    block.cells = ivec4(cells, static_cast<int>(capacity));
    block.body = vec4(space.acceleration, static_cast<float>(fluid.wetting));
    block.kernel = vec4(constants.kernelSelf, constants.soundSpeed * constants.soundSpeed, constants.friction,
                        constants.mushyDrag);
    block.tension =
        vec4(constants.cohesion, constants.area, fluid.tensionSlope / fluid.density, constants.wallFriction);
    block.search = vec4(reach, kFreeWay * fluid.spacing, constants.scale, 0);
    block.wetting = vec4(fluid.coldWetting, fluid.coldBelow, 1 / std::max(fluid.warmAbove - fluid.coldBelow, 1.0), 0);
    block.room = uvec4(static_cast<uint>(room), static_cast<uint>(cellCount(block)), 0, 0);
    block.buoyancy = vec4(fluid.expansion, fluid.evenTemperature, 0, 0);
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
    return (2 * room + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE * FLOW_NEIGHBOUR_ROOM;
}

unsigned groupsOf(size_t invocations) {
    return static_cast<unsigned>((invocations + GROUP_SIZE - 1) / GROUP_SIZE);
}

} // namespace

Flow::Flow(gl::ShaderLibrary& shaders, MetalState& state, const FlowFluid& fluid, const FlowSpace& space,
           size_t movingRoom)
    : state_(state),
      constants_(FlowConstants::of(fluid)),
      restDensity_(fluid.density),
      block_(makeBlock(constants_, fluid, space, state.capacity(),
                       movingRoom == 0 ? state.capacity() : std::min(movingRoom, state.capacity()))),
      belong_(shaders.compute("metal/flow/belong.comp", definesOf(space))),
      tidy_(shaders.compute("metal/flow/tidy.comp", definesOf(space))),
      enter_(shaders.compute("metal/flow/enter.comp", definesOf(space))),
      sort_(shaders.compute("metal/flow/sort.comp", definesOf(space))),
      search_(shaders.compute("metal/flow/search.comp", definesOf(space))),
      boundary_(shaders.compute("metal/flow/boundary.comp", definesOf(space))),
      density_(shaders.compute("metal/flow/density.comp", definesOf(space))),
      move_(shaders.compute("metal/flow/move.comp", definesOf(fluid, space))),
      blockBuffer_("flow block", sizeof(FlowBlock)),
      bodies_("flow bodies", state.capacity() * sizeof(FlowBody)),
      cells_("flow cells", cellCount(block_) * sizeof(FlowCell)),
      residents_("flow residents", cellCount(block_) * 4 * FLOW_CELL_ROOM * sizeof(uint)),
      entered_("flow entered", cellCount(block_) * FLOW_CELL_ROOM * sizeof(uint)),
      lists_("flow lists", (size_t(3) * block_.room.x + FLOW_RESTLESS_ROOM) * sizeof(uint)),
      neighbours_("flow neighbours", neighbourEntries(block_.room.x) * sizeof(uint)),
      counters_("flow counters", sizeof(FlowCounters)),
      dirty_("flow changed cells, slots", (cellCount(block_) + FLOW_STILL_CHANGES) * sizeof(uint)),
      resting_("flow still sums", state.capacity() * sizeof(ivec4)),
      positionTexels_("flow position texels", state.position, GL_RGBA32F, sizeof(vec4)),
      bodyTexels_("flow body texels", bodies_, GL_RGBA32F, sizeof(vec4)),
      neighbourTexels_("flow neighbour texels", neighbours_, GL_R32UI, sizeof(uint)),
      cellTexels_("flow cell texels", cells_, GL_RGBA32UI, sizeof(FlowCell)),
      residentTexels_("flow resident texels", residents_, GL_R32UI, sizeof(uint)),
      residentPlaceTexels_("flow resident place texels", residents_, GL_RGBA32UI, sizeof(uvec4)) {}

void Flow::bind() const {
    state_.bind();
    blockBuffer_.bindUniform(FLOW_BLOCK);
    bodies_.bindStorage(FLOW_BODIES);
    cells_.bindStorage(FLOW_CELLS);
    residents_.bindStorage(FLOW_RESIDENTS);
    entered_.bindStorage(FLOW_ENTERED);
    lists_.bindStorage(FLOW_LISTS);
    neighbours_.bindStorage(FLOW_NEIGHBOURS);
    counters_.bindStorage(FLOW_COUNTERS);
    dirty_.bindStorage(FLOW_DIRTY);
    resting_.bindStorage(FLOW_RESTING);
    state_.changes.bindStorage(FLOW_CHANGES);
    positionTexels_.bind(FLOW_TEXELS_POSITIONS);
    bodyTexels_.bind(FLOW_TEXELS_BODIES);
    neighbourTexels_.bind(FLOW_TEXELS_NEIGHBOURS);
    cellTexels_.bind(FLOW_TEXELS_CELLS);
    residentTexels_.bind(FLOW_TEXELS_RESIDENTS);
    residentPlaceTexels_.bind(FLOW_TEXELS_PLACES);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, counters_.name());
}

void Flow::setAcceleration(glm::vec3 acceleration) {
    block_.body = vec4(acceleration, block_.body.w);
    blockChanged_ = true;
}

void Flow::setArc(const ArcPressure& arc) {
    block_.arc = vec4(arc.place, 1 / (2 * arc.sigma * arc.sigma));
    block_.arcAxis = vec4(arc.axis, static_cast<double>(arc.peak) / restDensity_);
    blockChanged_ = true;
}

void Flow::step(double seconds, gl::Profiler* profiler) {
    step(seconds, constants_.substeps(seconds), profiler);
}

void Flow::step(double seconds, unsigned substeps, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "flow");
    const double dt = seconds / substeps;
    const auto stepLength = static_cast<float>(dt);
    if (blockChanged_ || block_.period.w != stepLength) {
        block_.period.w = stepLength;
        // Nothing may cross more than a third of a support in a substep: faster metal would pass through walls.
        block_.inversePeriod.w = static_cast<float>(constants_.support / (3 * dt));
        blockBuffer_.writeValue(block_);
        blockChanged_ = false;
    }
    bind();
    takeUpChanges(profiler);
    for (unsigned i = 0; i < substeps; ++i)
        substep(profiler);
}

void Flow::takeUpChanges(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "flow changes");
    const bool regrouped = regroupings_ != state_.regroupings();
    regroupings_ = state_.regroupings();
    const size_t known = regrouped ? 0 : known_;
    known_ = state_.particles();
    ++frame_;
    belong_.set("known", static_cast<unsigned>(known));
    belong_.set("slots", static_cast<unsigned>(known_));
    belong_.set("frame", frame_);
    belong_.dispatchGroups(std::clamp(groupsOf(known_ - known), kTidyGroups, kMostGroups));
    glMemoryBarrier(kBarrier);
    tidy_.set("frame", frame_);
    tidy_.set("substep", substep_ + 1);
    tidy_.dispatchGroups(kTidyGroups);
    glMemoryBarrier(kBarrier);
    enter_.set("frame", frame_);
    enter_.set("substep", substep_ + 1);
    enter_.dispatchGroups(kTidyGroups);
    glMemoryBarrier(kBarrier);
}

void Flow::substep(gl::Profiler* profiler) {
    substep_ = (substep_ + 1) % 0x7fffffffU;
    const auto pass = [&](const gl::Program& program, const char* name, size_t groups) {
        const gl::Scope scope(profiler, name);
        program.set("substep", substep_);
        program.dispatchIndirect(groups);
        glMemoryBarrier(kBarrier);
    };
    pass(sort_, "flow sort", offsetof(FlowCounters, search));
    pass(search_, "flow search", offsetof(FlowCounters, search));
    pass(boundary_, "flow boundary", offsetof(FlowCounters, boundary));
    pass(density_, "flow density", offsetof(FlowCounters, density));
    pass(move_, "flow move", offsetof(FlowCounters, moving));
}

FlowFaults Flow::readFaults() const {
    const auto faults = counters_.read<FlowCounters>(1)[0].faults;
    return {faults.x, faults.y, faults.z, faults.w};
}

unsigned Flow::readMoving() const {
    return counters_.read<FlowCounters>(1)[0].moving.w;
}

unsigned Flow::readSearches() const {
    return counters_.read<FlowCounters>(1)[0].spare.w;
}

std::vector<FlowBody> Flow::readBodies() const {
    return bodies_.read<FlowBody>(state_.particles());
}

size_t Flow::bytes() const {
    size_t sum = 0;
    for (const gl::Buffer* buffer : {&blockBuffer_, &bodies_, &cells_, &residents_, &entered_, &lists_, &neighbours_,
                                     &counters_, &dirty_, &resting_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
