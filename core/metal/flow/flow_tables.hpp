// The flow's tables that grow with the moving metal: neighbour lists, and pages of the cells' particles.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/state_archive.hpp"
#include "core/metal/flow/flow_capacity.hpp"

namespace meltpool {

/// Buffers of the sizes that FlowCapacity asks for. The flow's block stores the sizes, from which the places of their
/// parts follow.
class FlowTables {
  public:
    /// True if the sizes in `block` match those of `room`.
    static bool fits(const FlowCapacity& room, const FlowBlock& block);
    /// Resizes the tables to `room`, with the content that holds between two steps, and writes their sizes into
    /// `block`. Throws RuntimeFault if the driver has no memory.
    void fit(const FlowCapacity& room, FlowBlock& block);
    /// Makes empty tables of the sizes in `block`; none if there was no step.
    void makeAs(const FlowBlock& block);
    void clear() const;

    void bind() const;

    /// Transfers the pages of wall metal. The others hold for one search, neighbour lists for one step: the next step
    /// begins with a search for all.
    void transfer(gl::StateArchive& archive, const FlowBlock& block) const;
    size_t bytes() const { return neighbours_.bytes() + pages_.bytes(); } ///< GPU memory

  private:
    void growNeighbourLists(size_t rows, FlowBlock& block);
    void growPages(size_t wall, size_t moving, FlowBlock& block);
    void makeNeighbourTexels();
    void makePageTexels();

    gl::Buffer neighbours_, pages_;
    gl::BufferView neighbourTexels_, pageSlotTexels_, pagePositionTexels_;
};

} // namespace meltpool
