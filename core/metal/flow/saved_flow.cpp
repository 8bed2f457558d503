// What of the flow belongs to a saved state.
#include "core/base/error.hpp"
#include "core/metal/flow/flow.hpp"
#include "shaders/shared/dispatch.h"

namespace meltpool {

namespace {

constexpr size_t kNeighbourWords = FLOW_NEIGHBOUR_CAPACITY + 2; // of a row, see flow/common.glsl
constexpr size_t kPageBytes = FLOW_PAGE_WORDS * sizeof(uint);

} // namespace

/// Lists and pages as large as they were: the places of their parts follow from their size.
void Flow::takeSavedRoom() {
    if (static_cast<size_t>(block_.capacity) != state_.capacity() || block_.rowCapacity > room_.rows() ||
        block_.wallPageCapacity > 1 + room_.wallPages() || block_.movingPageCapacity > 1 + block_.cellCount)
        throw InputError(
            "the saved state has another room for the flow than the flow asked for; expected one that this "
            "program saved of this lesson");
    neighbours_ = {};
    pages_ = {};
    if (block_.rowCapacity == 0) return; // no step was made
    neighbours_ = gl::Buffer::gpuOnly("flow neighbours", kNeighbourWords * block_.rowCapacity * sizeof(uint));
    neighbourTexels_ = gl::BufferView("flow neighbour texels", neighbours_, GL_R32UI, sizeof(uint));
    pages_ = gl::Buffer::gpuOnly("flow pages", (block_.wallPageCapacity + block_.movingPageCapacity) * kPageBytes);
    pageSlotTexels_ = gl::BufferView("flow page slot texels", pages_, GL_R32UI, sizeof(uint));
    pagePositionTexels_ = gl::BufferView("flow page position texels", pages_, GL_RGBA32UI, sizeof(uvec4));
}

/// Pages of moving metal hold for one search only, neighbour lists for one step: the next one begins with a search for
/// all. Both are left out.
void Flow::transfer(gl::StateArchive& archive) {
    const size_t capacity = state_.capacity();
    archive.values(block_, regroupings_);
    archive.count(known_, capacity);
    room_.transfer(archive);
    if (archive.restores()) takeSavedRoom();
    archive.rows(particles_, state_.particles(), sizeof(FlowParticle));
    for (const gl::Buffer* buffer : {&cells_, &lists_, &counters_, &changed_})
        archive.list(*buffer, buffer->bytes());
    archive.list(nextInCell_, capacity * sizeof(uint));
    archive.rows(wallSums_, state_.particles(), sizeof(ivec4));
    if (block_.rowCapacity > 0) archive.list(pages_, block_.wallPageCapacity * kPageBytes);
    if (!archive.restores()) return;
    blockChanged_ = true;
    if (known_ > 0) room_.readNow(state_.particles(), counters_);
}

void Flow::fold() {
    if (block_.rowCapacity == 0) return; // no step was made
    bind();
    fold_.set("slots", static_cast<unsigned>(state_.particles()));
    fold_.dispatch(state_.particles() + block_.cellCount, GROUP_SIZE);
}

} // namespace meltpool
