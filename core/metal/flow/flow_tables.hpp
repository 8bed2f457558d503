// The flow's tables whose size follows the metal that moves: neighbour lists, and pages of the cells' particles.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/state_archive.hpp"
#include "core/metal/flow/flow_room.hpp"

namespace meltpool {

/// Buffers as large as FlowRoom asks for. Their sizes stand in the flow's block, which says where their parts begin.
class FlowTables {
  public:
    /// The tables of the sizes in `block` are as large as `room` says.
    static bool fits(const FlowRoom& room, const FlowBlock& block);
    /// Makes the tables as large as `room` says, with what holds between two steps, and writes their sizes into
    /// `block`. Throws RuntimeFault when the driver has no room.
    void fit(const FlowRoom& room, FlowBlock& block);
    /// Makes empty tables of the sizes in `block`; none where no step was made.
    void makeAs(const FlowBlock& block);
    void clear() const;

    void bind() const;

    /// Pages of wall metal. The others hold for one search, neighbour lists for one step: the next step begins with a
    /// search for all.
    void transfer(gl::StateArchive& archive, const FlowBlock& block) const;
    size_t bytes() const { return neighbours_.bytes() + pages_.bytes(); } ///< of GPU memory

  private:
    void growNeighbourLists(size_t rows, FlowBlock& block);
    void growPages(size_t wall, size_t moving, FlowBlock& block);
    void makeNeighbourTexels();
    void makePageTexels();

    gl::Buffer neighbours_, pages_;
    gl::BufferView neighbourTexels_, pageSlotTexels_, pagePositionTexels_;
};

} // namespace meltpool
