// Labels the connected fragments of solid metal, a small part in each call, and lists the particles of free ones.
#pragma once

#include "core/gl/buffer_view.hpp"
#include "core/gl/program.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/fragments.h"

namespace meltpool {

/// A cycle gives every solid particle the label of its fragment, numbers the fragments that nothing holds, and takes
/// their metal off the lattice. Its lists of coarse cells and of free particles serve the passes that move fragments.
class FragmentLabels {
  public:
    /// `state` and `block` (FragmentBlock) must outlive this object.
    FragmentLabels(gl::ShaderLibrary& shaders, MetalState& state, const gl::Buffer& block);

    /// Returns to the initial state without allocating.
    void reset();
    /// Adapts to the state's new capacity. Throws RuntimeFault if the driver has no memory.
    void onCapacityChanged();

    /// Makes the next part of a cycle; returns true for the last part.
    bool advance();
    /// Makes a whole cycle at once, from its beginning.
    void cycleNow();

    /// Binds state, block, labels and lists.
    void bind() const;
    const gl::Buffer& control() const { return control_; } ///< FragmentControl

    void transfer(gl::StateArchive& archive);
    size_t bytes() const; ///< GPU memory

  private:
    void makeTexels();
    void begin();
    void joinPart();
    void finish();

    MetalState& state_;
    const gl::Buffer& block_;
    int call_ = 0;      ///< calls of advance() in this cycle
    size_t slots_ = 0;  ///< slots at the cycle's beginning
    size_t joined_ = 0; ///< joined slots
    gl::Buffer cellHeads_, cellNext_, labels_, firstLabels_, control_, freeSlots_;
    gl::BufferView firstLabelTexels_, latticeTexels_, positionTexels_;
    const gl::Program &beginLabels_, &join_, &countMembers_, &numberFragments_, &assignFragments_, &listFree_;
};

} // namespace meltpool
