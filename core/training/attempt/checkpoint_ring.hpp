// Stores in memory the checkpoints that the running attempt can go back to.
#pragma once

#include "core/training/attempt/checkpoint_capture.hpp"

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace meltpool {

/// Limits of the stored checkpoints.
struct CheckpointRingLimits {
    double period = 1;                ///< metal time from one checkpoint to the next, s
    size_t bytes = size_t(192) << 20; ///< bytes of memory, including the buffers that make checkpoints
};

/// A checkpoint, delta-compressed against the attempt's first one (the first against nothing), without the hand's
/// steps.
struct PackedCheckpoint {
    size_t step = 0;
    double time = 0; ///< metal time, s
    std::span<const std::byte> bytes;
};
using CheckpointTaker = std::function<void(const PackedCheckpoint&)>;

/// A frame that starts a checkpoint copies the state on the GPU, some forty commands, and allocates nothing; a worker
/// thread assembles and packs the bytes when they have arrived. At the memory limit the checkpoints closest together
/// for their age are dropped: the last seconds stay dense, and a long attempt can go back to its start. Checkpoints of
/// one attempt may come in any order: equal times have equal states, until branch().
///
/// All functions belong to the thread that has the GPU's context.
class CheckpointRing {
  public:
    explicit CheckpointRing(const CheckpointRingLimits& limits = {});
    ~CheckpointRing();
    CheckpointRing(const CheckpointRing&) = delete;
    CheckpointRing& operator=(const CheckpointRing&) = delete;

    /// Starts another attempt and drops all checkpoints. `taker` receives each checkpoint, on the thread that packs,
    /// before any waiting call such as before() returns. `keeps`: false if no checkpoint is ever gone back to; then
    /// checkpoints are made for the taker alone.
    void clear(CheckpointTaker taker = {}, bool keeps = true);

    /// True if a checkpoint is due at this metal time (s): hand capture() and historyTo() to Trainer::capture(), then
    /// call begun(). `period`: s from one checkpoint to the next, instead of the limits' own. Never waits.
    bool due(double time) { return due(time, limits_.period); }
    bool due(double time, double period);
    CheckpointCapture& capture() { return capture_; }
    /// Steps of the hand that are stored already.
    size_t historyTo() const { return historyTo_; }
    /// Call it when a checkpoint is on its way from the GPU. `historyTo`: steps of the hand known with it.
    void begun(double time, size_t historyTo);
    /// Passes an arrived checkpoint to the worker. Call it once a frame. Never waits.
    void update();

    /// The newest checkpoint not after `time` (s), whole; empty if there is none. Waits for a packing in progress, some
    /// ten milliseconds.
    std::optional<Checkpoint> before(double time);
    /// Call it when the attempt went back to this step: later checkpoints belong to the abandoned branch.
    void branch(size_t step);

    size_t count();
    /// Memory of everything, CPU and GPU; at most a little more than the limit.
    size_t bytes();
    const CheckpointRingLimits& limits() const { return limits_; }
    /// Reason why a checkpoint could not be stored, as a sentence; empty without a fault. After a fault no more
    /// checkpoints are taken.
    std::string fault();

  private:
    enum class Stage { idle, onGpu, packing };

    struct KeptCheckpoint {
        size_t step = 0;
        double time = 0;
        size_t historyTo = 0;
        std::vector<std::byte> packed; ///< packed against reference_; empty for reference_ itself
    };

    void work();
    KeptCheckpoint packed();
    void addHistory();
    void give(const KeptCheckpoint& moment) const;
    bool covers(double time, double period) const;
    void thinOut();
    size_t bytesNow() const;
    std::unique_lock<std::mutex> whenIdle();
    Checkpoint whole(size_t number) const;

    const CheckpointRingLimits limits_;
    CheckpointCapture capture_;
    double last_ = -std::numeric_limits<double>::infinity(); ///< s, time of the checkpoint begun last
    size_t historyTo_ = 0;
    bool keeps_ = true;
    CheckpointTaker taker_; ///< called only while a checkpoint is packed, changed only while none is

    std::mutex mutex_; ///< guards all below; packing runs without it and changes only fresh_, reference_ and history_
    std::condition_variable changed_;
    Stage stage_ = Stage::idle;
    bool stops_ = false;
    std::string fault_;
    Checkpoint fresh_;                        ///< buffer reused for each checkpoint
    Checkpoint reference_;                    ///< the attempt's first checkpoint
    std::vector<std::byte> history_;          ///< steps of the hand, from the first on
    size_t historyKept_ = 0;                  ///< steps in history_
    std::vector<KeptCheckpoint> checkpoints_; ///< sorted by time
    std::thread worker_;                      ///< runs from the first checkpoint on
};

} // namespace meltpool
