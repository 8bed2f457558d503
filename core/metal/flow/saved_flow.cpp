// Saves and restores the flow.
#include "core/base/error.hpp"
#include "core/metal/flow/flow.hpp"
#include "shaders/shared/dispatch.h"

namespace meltpool {

/// Restores the old sizes of lists and pages: the places of their parts follow from them.
void Flow::takeSavedRoom() {
    if (static_cast<size_t>(block_.capacity) != state_.capacity() || block_.rowCapacity > capacity_.rows() ||
        block_.wallPageCapacity > 1 + capacity_.wallPages() || block_.movingPageCapacity > 1 + block_.cellCount)
        throw InputError("the saved state has other list sizes of the flow than this lesson; expected one of this "
                         "lesson, saved by this "
                         "program");
    tables_.makeAs(block_);
}

void Flow::transfer(gl::StateArchive& archive) {
    const size_t capacity = state_.capacity();
    archive.values(block_, regroupings_);
    archive.count(known_, capacity);
    capacity_.transfer(archive);
    if (archive.restores()) takeSavedRoom();
    archive.rows(particles_, state_.particles(), sizeof(FlowParticle));
    for (const gl::Buffer* buffer : {&cells_, &lists_, &counters_, &changed_})
        archive.list(*buffer, buffer->bytes());
    archive.list(nextInCell_, capacity * sizeof(uint));
    archive.rows(wallSums_, state_.particles(), sizeof(ivec4));
    tables_.transfer(archive, block_);
    if (!archive.restores()) return;
    blockChanged_ = true;
    if (known_ > 0) capacity_.readNow(state_.particles(), counters_);
}

void Flow::xorOutDerivedState() {
    if (block_.rowCapacity == 0) return; // no step so far
    bind();
    xorOutDerived_.set("slots", static_cast<unsigned>(state_.particles()));
    xorOutDerived_.dispatch(state_.particles() + block_.cellCount, GROUP_SIZE);
}

} // namespace meltpool
