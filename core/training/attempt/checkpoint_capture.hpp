// Copies a checkpoint from the GPU without waiting.
#pragma once

#include "core/training/attempt/checkpoint.hpp"

namespace meltpool {

/// Trainer::capture() starts it; some frames later the copy has arrived and can be taken. The memory is reused for the
/// next checkpoint, so that a frame that starts one allocates nothing.
class CheckpointCapture {
  public:
    CheckpointCapture();

    /// Starts a capture, for Trainer: fill the returned head at once and send the rest to state(). Drops a capture in
    /// progress.
    Checkpoint& begin();
    gl::StateParts& state() { return *parts_; }
    /// Starts the copy on the GPU, for Trainer, without waiting.
    void request() { capture_.request(); }

    /// True once the copy has arrived; never waits.
    bool arrived() { return capture_.arrived(); }
    void wait() { capture_.wait(); }

    /// Fills `checkpoint` and seals it. Call it only after arrived(). Any thread may call it, but the next begin() must
    /// wait for it.
    void take(Checkpoint& checkpoint) const;

    /// Memory of CPU and GPU, bytes.
    size_t bytes() const { return capture_.bytes() + head_.history.capacity(); }

  private:
    Checkpoint head_; ///< everything except the state
    gl::StateCapture capture_;
    gl::StateParts* parts_;
};

} // namespace meltpool
