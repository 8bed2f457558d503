// The moments of the running attempt that it can go back to, kept in memory.
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

/// Limits of what is kept.
struct KeptMomentsLimits {
    double period = 1;                ///< s of the metal's time from one moment to the next
    size_t bytes = size_t(192) << 20; ///< of memory, with what is needed to make moments
};

/// A moment as it was packed: against the first one of its attempt, the first one against nothing; without the hand's
/// steps.
struct PackedMoment {
    size_t step = 0;
    double time = 0; ///< s of the metal's
    std::span<const std::byte> bytes;
};
using MomentTaker = std::function<void(const PackedMoment&)>;

/// A frame in which a moment begins copies the state on the GPU, some forty commands, and allocates nothing; a thread
/// of its own puts the bytes together and packs them when they have arrived. Where the memory's limit is reached,
/// moments are left out that lie closest together for their age: the last seconds stay dense, and a long attempt can be
/// gone back to its beginning. Moments of one attempt may come in any order: the same time has the same state, until
/// branch().
///
/// All functions belong to the thread that has the GPU's context.
class KeptMoments {
  public:
    explicit KeptMoments(const KeptMomentsLimits& limits = {});
    ~KeptMoments();
    KeptMoments(const KeptMoments&) = delete;
    KeptMoments& operator=(const KeptMoments&) = delete;

    /// Another attempt: nothing is kept. `taker` is given each of its moments, on the thread that packs, before
    /// anything that waits for it, such as before(), goes on. `keeps`: false where nobody goes back, and moments are
    /// made for the taker alone.
    void clear(MomentTaker taker = {}, bool keeps = true);

    /// A moment should be taken now, at this time of the metal (s): hand capture() and historyTo() to
    /// Trainer::capture(), then call begun(). `period`: s from one moment to the next, where not the limits' own. Never
    /// waits.
    bool due(double time) { return due(time, limits_.period); }
    bool due(double time, double period);
    CheckpointCapture& capture() { return capture_; }
    /// Steps of the hand that are kept already.
    size_t historyTo() const { return historyTo_; }
    /// A moment is on its way from the GPU. `historyTo`: steps of the hand that are known by it.
    void begun(double time, size_t historyTo);
    /// Once a frame: hands on what has arrived. Never waits.
    void update();

    /// The newest moment that is not after `time` (s), whole; nothing where none is kept. Waits for a packing that is
    /// under way, some ten milliseconds.
    std::optional<Checkpoint> before(double time);
    /// The attempt went back to this step: the moments after it are those of an end that was given up.
    void branch(size_t step);

    size_t count();
    /// Memory of it all, CPU and GPU; at most a little more than the limit.
    size_t bytes();
    const KeptMomentsLimits& limits() const { return limits_; }
    /// Why a moment could not be kept, as a sentence; empty while all could. Then none is taken any more.
    std::string fault();

  private:
    enum class Stage { idle, onGpu, packing };

    struct Moment {
        size_t step = 0;
        double time = 0;
        size_t historyTo = 0;
        std::vector<std::byte> packed; ///< against reference_; empty of the one that it is
    };

    void work();
    Moment packed();
    void addHistory();
    void give(const Moment& moment) const;
    bool covers(double time, double period) const;
    void thinOut();
    size_t bytesNow() const;
    std::unique_lock<std::mutex> whenIdle();
    Checkpoint whole(size_t number) const;

    const KeptMomentsLimits limits_;
    CheckpointCapture capture_;
    double last_ = -std::numeric_limits<double>::infinity(); ///< s, of the moment that was begun last
    size_t historyTo_ = 0;
    bool keeps_ = true;
    MomentTaker taker_; ///< called while a moment is packed, changed while none is

    std::mutex mutex_; ///< for all below; packing goes on without it, and changes fresh_, reference_ and history_ alone
    std::condition_variable changed_;
    Stage stage_ = Stage::idle;
    bool stops_ = false;
    std::string fault_;
    Checkpoint fresh_;               ///< memory that is kept from one moment to the next
    Checkpoint reference_;           ///< the first moment that was made
    std::vector<std::byte> history_; ///< of the hand, from the first step on
    size_t historyKept_ = 0;         ///< steps in it
    std::vector<Moment> moments_;    ///< in the order of their times
    std::thread worker_;             ///< from the first moment on
};

} // namespace meltpool
