#include "core/metal/flow/flow_tables.hpp"

#include "core/gl/order.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

namespace {

constexpr size_t kNeighbourWords = FLOW_NEIGHBOUR_CAPACITY + 2; // words of a row, see flow/common.glsl
constexpr size_t kPageBytes = FLOW_PAGE_WORDS * sizeof(uint);

/// Greatest number of pages of moving metal: each liquid particle may be alone in its cell, and fragments take the
/// place of wall metal. Liquid takes half the rows at most, as long as there can be more.
size_t movingPages(const FlowCapacity& room, const FlowBlock& block) {
    const auto slots = static_cast<size_t>(block.capacity);
    const size_t liquids = room.rows() < slots ? room.rows() / 2 : slots;
    return std::min<size_t>(block.cellCount, liquids + room.wallPages());
}

} // namespace

bool FlowTables::fits(const FlowCapacity& room, const FlowBlock& block) {
    return room.rows() == block.rowCapacity && 1 + room.wallPages() == block.wallPageCapacity &&
           1 + movingPages(room, block) == block.movingPageCapacity;
}

void FlowTables::fit(const FlowCapacity& room, FlowBlock& block) {
    if (room.rows() != block.rowCapacity) growNeighbourLists(room.rows(), block);
    if (!fits(room, block)) growPages(1 + room.wallPages(), 1 + movingPages(room, block), block);
}

void FlowTables::growNeighbourLists(size_t rows, FlowBlock& block) {
    const size_t old = block.rowCapacity * sizeof(uint), row = rows * sizeof(uint);
    auto grown = gl::Buffer::gpuOnly("flow neighbours", kNeighbourWords * row);
    if (neighbours_) {
        gl::memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        neighbours_.copyTo(grown, FLOW_NEIGHBOUR_CAPACITY * old);
        for (const size_t part : {FLOW_NEIGHBOUR_CAPACITY, FLOW_NEIGHBOUR_CAPACITY + 1})
            neighbours_.copyTo(grown, old, part * old, part * row);
    }
    neighbours_ = std::move(grown);
    makeNeighbourTexels();
    block.rowCapacity = static_cast<uint>(rows);
}

void FlowTables::growPages(size_t wall, size_t moving, FlowBlock& block) {
    block.wallPageCapacity = static_cast<uint>(wall);
    block.movingPageCapacity = static_cast<uint>(moving);
    auto pages = gl::Buffer::gpuOnly("flow pages", (block.wallPageCapacity + block.movingPageCapacity) * kPageBytes);
    if (pages_) {
        // Transfers the pages of wall metal; the others hold for one search only.
        gl::memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        pages_.copyTo(pages, std::min(pages.bytes(), pages_.bytes()));
    }
    pages_ = std::move(pages);
    makePageTexels();
}

void FlowTables::makeAs(const FlowBlock& block) {
    neighbours_ = {};
    pages_ = {};
    if (block.rowCapacity == 0) return; // no step so far
    neighbours_ = gl::Buffer::gpuOnly("flow neighbours", kNeighbourWords * block.rowCapacity * sizeof(uint));
    makeNeighbourTexels();
    pages_ = gl::Buffer::gpuOnly("flow pages", (block.wallPageCapacity + block.movingPageCapacity) * kPageBytes);
    makePageTexels();
}

void FlowTables::makeNeighbourTexels() {
    neighbourTexels_ = gl::BufferView("flow neighbour texels", neighbours_, GL_R32UI, sizeof(uint));
}

void FlowTables::makePageTexels() {
    pageSlotTexels_ = gl::BufferView("flow page slot texels", pages_, GL_R32UI, sizeof(uint));
    pagePositionTexels_ = gl::BufferView("flow page position texels", pages_, GL_RGBA32UI, sizeof(uvec4));
}

void FlowTables::clear() const {
    for (const gl::Buffer* buffer : {&pages_, &neighbours_})
        if (*buffer) buffer->clear();
}

void FlowTables::bind() const {
    pages_.bindStorage(FLOW_PAGES);
    neighbours_.bindStorage(FLOW_NEIGHBOURS);
    neighbourTexels_.bind(FLOW_TEXELS_NEIGHBOURS);
    pageSlotTexels_.bind(FLOW_TEXELS_PAGE_SLOTS);
    pagePositionTexels_.bind(FLOW_TEXELS_PAGE_POSITIONS);
}

void FlowTables::transfer(gl::StateArchive& archive, const FlowBlock& block) const {
    if (block.rowCapacity > 0) archive.list(pages_, block.wallPageCapacity * kPageBytes);
}

} // namespace meltpool
