// How much room the flow's lists need: it follows the metal that moves, not all there is.
#pragma once

#include "core/gl/readback.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/flow.h"

namespace meltpool {

/// Sizes the neighbour lists and the pages of wall metal. Grows both long before they are full, by what the GPU's
/// counters say a few steps later; nothing waits in a frame. Room that is larger than needed changes no result.
class FlowRoom {
  public:
    FlowRoom();

    /// Room for what the metal is before its first step, no less than there was before. `block`: its cells are filled
    /// in. Waits for the GPU.
    void start(const MetalState& state, const FlowBlock& block);

    /// After the number of slots that there can be became another one: `slots`.
    void setSlots(size_t slots);

    /// Makes room for `particles` slots (handed out so far). Waits for the GPU only where its last answer is
    /// kMostStepsBehind steps old, which no frame lets happen.
    void update(size_t particles, const gl::Buffer& counters);

    /// Makes the next update() know what is in use now. Waits for the GPU.
    void readNow(size_t particles, const gl::Buffer& counters);

    /// Asks how much of the room is in use now, for a later update().
    void request(size_t particles, const gl::Buffer& counters);

    /// Saves or restores how much room there is. What is in use is known again after readNow().
    void transfer(gl::StateArchive& archive);

    size_t rows() const { return rows_; }       ///< neighbour lists, a multiple of GROUP_SIZE
    size_t wallPages() const { return pages_; } ///< lists of cells of wall metal

  private:
    static constexpr int kMostStepsBehind = 8;

    struct Use {
        size_t rows = 0, pages = 0; ///< of wall metal
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
    size_t mostRows_ = 0, mostPages_ = 0; ///< enough whatever happens
};

} // namespace meltpool
