// What of the heat solver belongs to a saved state.
#include "core/metal/heat/heat.hpp"

namespace meltpool {

/// Sums and ranges of cells are zero between steps: they are kept all the same, as zeros cost nothing and nobody has to
/// know here what the passes clear. Sums of sources are made in each step.
void HeatSolver::transfer(gl::StateArchive& archive) {
    archive.values(block_, regroupings_, time_);
    archive.count(searched_, state_.capacity());
    for (const gl::Buffer* buffer : {&cellTheta_, &cellSums_, &ledger_})
        archive.buffer(*buffer, buffer->bytes());
    for (const gl::Buffer* buffer :
         {&cellWeight_, &cellRanges_, &tiles_, &tileStamps_, &lists_, &control_, &knownCells_})
        archive.list(*buffer, buffer->bytes());
    if (archive.restores()) blockBuffer_.writeValue(block_);
}

void HeatSolver::fold() {
    const size_t cells = state_.lattice().cellCount();
    bind();
    fold_->set("cells", static_cast<unsigned>(cells));
    fold_->set("slots", static_cast<unsigned>(state_.particles()));
    fold_->dispatch(cells + state_.particles(), GROUP_SIZE);
}

} // namespace meltpool
