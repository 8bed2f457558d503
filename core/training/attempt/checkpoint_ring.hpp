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

/// A checkpoint stored as its differences from the attempt's first one. The first is stored whole. The hand's steps are
/// left out.
struct PackedCheckpoint {
    size_t step = 0;
    double time = 0;                  ///< metal time, s
    std::span<const std::byte> bytes; ///< valid during the call of the taker
};
using CheckpointTaker = std::function<void(const PackedCheckpoint&)>;

/// Holds the checkpoints of an attempt. To start one adds some forty commands to a frame, which copy the state on the
/// GPU, and allocates nothing. When the bytes have arrived, a worker thread packs them. At the memory limit the ring
/// drops the checkpoint whose gap between its neighbours is smallest for its age, never the first: the last seconds
/// stay dense, and a long attempt can go back to its start. A replay may add checkpoints in any order of time, because
/// one time has one state until branch().
///
/// Call all functions on the thread that has the GPU's context.
class CheckpointRing {
  public:
    explicit CheckpointRing(const CheckpointRingLimits& limits = {});
    ~CheckpointRing();
    CheckpointRing(const CheckpointRing&) = delete;
    CheckpointRing& operator=(const CheckpointRing&) = delete;

    /// Starts another attempt, drops all checkpoints and the fault. Waits while the worker packs. The worker calls
    /// `taker` with each checkpoint; clear(), before(), branch() and bytes() return only after that call. `keeps`:
    /// false stores nothing and makes checkpoints for the taker alone.
    void clear(CheckpointTaker taker = {}, bool keeps = true);

    /// Passes each checkpoint from the next one on to `taker` instead. Waits while the worker packs.
    void giveTo(CheckpointTaker taker);

    /// True if a checkpoint is due at this time of the metal (s). Then pass capture() and historyTo() to
    /// Trainer::capture(), and call begun(). `period`: s from one checkpoint to the next, instead of the limits' own.
    /// Never waits.
    bool due(double time) { return due(time, limits_.period); }
    bool due(double time, double period);
    CheckpointCapture& capture() { return capture_; }
    /// Number of the hand's steps that are stored so far.
    size_t historyTo() const { return historyTo_; }
    /// Call it when a checkpoint is on its way from the GPU. `historyTo`: number of the hand's steps up
    /// to this checkpoint.
    void begun(double time, size_t historyTo);
    /// Passes an arrived checkpoint to the worker. Call it once a frame. Never waits.
    void update();

    /// The newest checkpoint not after `time` (s), whole; empty if there is none. Waits while the worker packs, some
    /// ten milliseconds, and not for a checkpoint that is on its way from the GPU.
    std::optional<Checkpoint> before(double time);
    /// Drops the checkpoints after `step`, one on its way from the GPU, and the hand's later steps. Call it when the
    /// attempt went back to this step. Waits while the worker packs.
    void branch(size_t step);

    size_t count();
    /// Bytes in use, CPU and GPU. The newest checkpoints stay even above the limit. Waits while the worker packs.
    size_t bytes();
    const CheckpointRingLimits& limits() const { return limits_; }
    /// Reason why a checkpoint could not be stored, as a sentence; empty without a fault. After a fault no more
    /// checkpoints are made until clear().
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

    /// Guards all below. While `stage_` is packing, the worker alone uses fresh_, reference_ and history_, without it.
    std::mutex mutex_;
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
