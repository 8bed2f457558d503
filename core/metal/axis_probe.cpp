#include "core/metal/axis_probe.hpp"

#include "core/gl/order.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <numbers>

namespace meltpool {

namespace {

constexpr unsigned kSlotGroups = 32;

} // namespace

AxisProbe::AxisProbe(gl::ShaderLibrary& shaders, const MetalState& state, const HeatSolver& heat)
    : state_(state),
      heat_(heat),
      count_(shaders.compute("metal/axis_probe_count.comp")),
      find_(shaders.compute("metal/axis_probe_find.comp")),
      blockBuffer_("axis probe block", sizeof(AxisProbeBlock)),
      bins_("axis probe bins", AXIS_PROBE_BINS * sizeof(AxisProbeBin)),
      answer_("axis probe answer", sizeof(AxisProbeAnswer)) {
    bins_.clear();
    // The weight (1 - r²/R²)² has the integral pi R²/3 over the plane, where a particle covers a square spacing.
    full_ = static_cast<float>(std::numbers::pi / 3 * AXIS_PROBE_RADIUS * AXIS_PROBE_RADIUS);
}

void AxisProbe::reset() {
    bins_.clear();
    for (Pending& pending : pending_)
        pending.readback.forget();
    looks_ = 0;
}

void AxisProbe::transfer(gl::StateArchive& archive) {
    archive.count(looks_, std::numeric_limits<size_t>::max());
    for (Pending& pending : pending_) {
        archive.values(pending.ray.origin, pending.ray.axis, pending.ray.reach);
        archive.answer(pending.readback, answer_);
    }
    if (archive.restores()) bins_.clear();
}

AxisProbeBlock AxisProbe::blockOf(const ProbeRay& ray) const {
    const MetalLattice& lattice = state_.lattice();
    const OffLatticeList list = heat_.offLattice();
    AxisProbeBlock block{};
    block.origin = ray.origin;
    block.axis = ray.axis;
    block.binLength = ray.reach / AXIS_PROBE_BINS;
    block.full = full_;
    block.edgeBins =
        std::max(static_cast<int>(static_cast<float>(AXIS_PROBE_EDGE_DEPTH) * lattice.spacing / block.binLength), 1);
    const glm::vec3 end = ray.origin + ray.axis * ray.reach;
    const float margin = (static_cast<float>(AXIS_PROBE_RADIUS) + 1) * lattice.spacing;
    const glm::ivec3 last = lattice.cells() - 1;
    const CellBox& metal = state_.latticeMetal();
    const auto cellAt = [&](glm::vec3 place) {
        const glm::vec3 cell = glm::clamp((place - lattice.low) / lattice.spacing, glm::vec3(-1), glm::vec3(last + 1));
        return glm::clamp(glm::ivec3(glm::floor(cell)), metal.low, metal.high);
    };
    block.low = cellAt(glm::min(ray.origin, end) - margin);
    block.cells = cellAt(glm::max(ray.origin, end) + margin) - block.low + 1;
    const int count = block.cells.x * block.cells.y * block.cells.z;
    block.latticeGroups = std::clamp((count + AXIS_PROBE_GROUP - 1) / AXIS_PROBE_GROUP, 1, AXIS_PROBE_LATTICE_GROUPS);
    block.firstSlot = static_cast<uint>(list.first);
    block.countWord = static_cast<uint>(list.count / sizeof(uint));
    return block;
}

void AxisProbe::look(const ProbeRay& ray, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "axis probe");
    const OffLatticeList list = heat_.offLattice();
    const AxisProbeBlock block = blockOf(ray);
    blockBuffer_.writeValue(block);
    state_.bind();
    blockBuffer_.bindUniform(AXIS_PROBE_BLOCK);
    bins_.bindStorage(AXIS_PROBE_SUMS);
    answer_.bindStorage(AXIS_PROBE_ANSWER);
    list.slots.bindStorage(AXIS_PROBE_SLOTS);
    list.control.bindStorage(AXIS_PROBE_CONTROL);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    count_.dispatchGroups(static_cast<unsigned>(block.latticeGroups) + kSlotGroups); // particles -> bins
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    find_.dispatchGroups(1); // bins -> answer
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    Pending& pending = pending_[looks_++ % kDelay];
    pending.ray = ray;
    pending.readback.request(answer_);
}

std::optional<MetalOnAxis> AxisProbe::answer() {
    if (looks_ < kDelay) return std::nullopt;
    Pending& pending = pending_[looks_ % kDelay];
    const auto found = pending.readback.await<AxisProbeAnswer>();
    if (!found) return std::nullopt;
    MetalOnAxis metal{pending.ray, std::nullopt, found->liquid};
    if (found->distance >= 0) metal.distance = found->distance;
    return metal;
}

size_t AxisProbe::bytes() const {
    return blockBuffer_.bytes() + bins_.bytes() + answer_.bytes();
}

} // namespace meltpool
