#include "core/metal/flow/flow_capacity.hpp"

#include "shaders/shared/dispatch.h"

#include <glm/common.hpp>

#include <algorithm>

namespace meltpool {

namespace {

constexpr size_t kLeastRows = 2048;
constexpr size_t kRowsEach = 4; ///< rows of a new liquid particle: its own, and those of adjacent solid metal
constexpr size_t kLeastPages = 128;

size_t wholeGroups(size_t rows) {
    return (rows + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE;
}

/// Number of cells that hold metal.
size_t filledCells(const std::vector<vec4>& positions, const FlowBlock& block) {
    std::vector<bool> filled(block.cellCount);
    size_t count = 0;
    for (const vec4& position : positions) {
        const glm::vec3 inCells = (glm::vec3(position) - block.origin) * block.inverseCellSize;
        const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(inCells)), glm::ivec3(0), block.cells - 1);
        const auto index = static_cast<size_t>((cell.z * block.cells.y + cell.y) * block.cells.x + cell.x);
        if (!filled[index]) ++count;
        filled[index] = true;
    }
    return count;
}

} // namespace

FlowCapacity::FlowCapacity() : readback_("flow counters", sizeof(FlowCounters)) {}

void FlowCapacity::start(const MetalState& state, const FlowBlock& block) {
    readback_.forget();
    requested_ = false;
    setSlots(state.capacity());
    mostPages_ = block.cellCount;
    use_.particles = state.particles();
    const auto phases = state.phase.read<uint>(use_.particles);
    const auto liquid = [](uint bits) { return (bits & PHASE_LIQUID) != 0; };
    use_.rows = kRowsEach / 2 * static_cast<size_t>(std::count_if(phases.begin(), phases.end(), liquid));
    use_.pages = filledCells(state.position.read<vec4>(use_.particles), block);
    rows_ = std::max(rows_, std::min(mostRows_, wholeGroups(std::max(kLeastRows, 2 * use_.rows))));
    growPages(use_.pages);
}

void FlowCapacity::setSlots(size_t slots) {
    mostRows_ = wholeGroups(slots);
}

void FlowCapacity::readNow(size_t particles, const gl::Buffer& counters) {
    readback_.forget();
    requested_ = false;
    const FlowCounters now = counters.read<FlowCounters>(1).front();
    use_ = {now.liquids + now.boundary, now.wallPages, particles};
}

void FlowCapacity::update(size_t particles, const gl::Buffer& counters) {
    if (requested_) {
        const auto answer = readback_.poll<FlowCounters>();
        if (answer) {
            use_ = {answer->liquids + answer->boundary, answer->wallPages, requestedFor_};
            requested_ = false;
        } else if (++stepsBehind_ >= kMostStepsBehind) {
            readNow(use_.particles, counters); // new slots may not have been in a step yet
        }
    }
    const size_t added = particles - use_.particles;
    growRows(use_.rows + kRowsEach * added);
    growPages(use_.pages + added);
}

void FlowCapacity::request(size_t particles, const gl::Buffer& counters) {
    if (requested_) return;
    readback_.request(counters);
    requested_ = true;
    requestedFor_ = particles;
    stepsBehind_ = 0;
}

void FlowCapacity::transfer(gl::StateArchive& archive) {
    constexpr size_t kMost = size_t(1) << 31;
    for (size_t* each : {&mostRows_, &mostPages_})
        archive.count(*each, kMost);
    archive.count(rows_, mostRows_);
    archive.count(pages_, mostPages_);
    if (!archive.restores()) return;
    readback_.forget();
    requested_ = false;
    stepsBehind_ = 0;
}

void FlowCapacity::growRows(size_t need) {
    if (2 * need <= rows_) return;
    rows_ = std::min(mostRows_, wholeGroups(std::max(2 * rows_, 3 * need)));
}

/// Grows by little: wall metal enters new cells only by freezing there.
void FlowCapacity::growPages(size_t need) {
    if (need + need / 16 + kLeastPages / 2 <= pages_) return;
    pages_ = std::min(mostPages_, need + need / 8 + kLeastPages);
}

} // namespace meltpool
