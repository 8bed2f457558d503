// A checkpoint on its way from the GPU.
#pragma once

#include "core/training/attempt/checkpoint.hpp"

namespace meltpool {

/// Trainer::capture() begins it; frames later it has arrived and can be taken. Its memory is kept from one checkpoint
/// to the next, so that a frame in which one begins allocates nothing.
class CheckpointCapture {
  public:
    CheckpointCapture();

    /// For Trainer: what is known at once goes into the head, the rest to state(). Drops what was under way.
    Checkpoint& begin();
    gl::StateParts& state() { return *parts_; }
    /// For Trainer: copies on the GPU, without waiting.
    void request() { capture_.request(); }

    /// Whether it has come; never waits.
    bool arrived() { return capture_.arrived(); }
    void wait() { capture_.wait(); }

    /// Fills `checkpoint` and seals it; once it has arrived. Any thread may do this, but the next begin() must wait.
    void take(Checkpoint& checkpoint) const;

    /// Memory, CPU and GPU, bytes.
    size_t bytes() const { return capture_.bytes() + head_.history.capacity(); }

  private:
    Checkpoint head_; ///< all but the state
    gl::StateCapture capture_;
    gl::StateParts* parts_;
};

} // namespace meltpool
