// The capacity of the flow's lists: it follows the moving metal, not all metal.
#pragma once

#include "core/gl/readback.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/flow.h"

namespace meltpool {

/// Sizes the neighbour lists and the pages of wall metal. Grows both long before they are full, from counters of the
/// GPU that arrive a few steps later; nothing waits in a frame. Spare capacity changes no result.
class FlowCapacity {
  public:
    FlowCapacity();

    /// Sets the capacity for the metal before its first step, no less than before. `block`: its cells are filled in.
    /// Waits for the GPU.
    void start(const MetalState& state, const FlowBlock& block);

    /// Sets the greatest possible number of slots.
    void setSlots(size_t slots);

    /// Provides capacity for `particles` slots (handed out so far). Waits for the GPU only if its last answer is
    /// kMostStepsBehind steps old, which does not happen in a frame.
    void update(size_t particles, const gl::Buffer& counters);

    /// Reads the present use for the next update(). Waits for the GPU.
    void readNow(size_t particles, const gl::Buffer& counters);

    /// Requests the present use for a later update().
    void request(size_t particles, const gl::Buffer& counters);

    /// Saves or restores the capacity. The use is known again after readNow().
    void transfer(gl::StateArchive& archive);

    size_t rows() const { return rows_; }       ///< neighbour lists, a multiple of GROUP_SIZE
    size_t wallPages() const { return pages_; } ///< lists of cells of wall metal

  private:
    static constexpr int kMostStepsBehind = 8;

    struct Use {
        size_t rows = 0, pages = 0; ///< rows of neighbour lists; pages of wall metal
        size_t particles = 0;       ///< slots handed out at that time
    };

    void growRows(size_t need);
    void growPages(size_t need);

    gl::Readback readback_;
    Use use_;
    bool requested_ = false;
    size_t requestedFor_ = 0; ///< particles at the time of the request
    int stepsBehind_ = 0;
    size_t rows_ = 0, pages_ = 0;
    size_t mostRows_ = 0, mostPages_ = 0; ///< upper limits for any motion
};

} // namespace meltpool
