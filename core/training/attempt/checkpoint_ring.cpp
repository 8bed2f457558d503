#include "core/training/attempt/checkpoint_ring.hpp"

#include "core/base/error.hpp"
#include "core/training/attempt/packing.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <utility>

namespace meltpool {

namespace {

/// Checkpoints that are never dropped: the newest ones, and all while there are fewer than this.
constexpr size_t kNewest = 8;

} // namespace

CheckpointRing::CheckpointRing(const CheckpointRingLimits& limits) : limits_(limits) {}

CheckpointRing::~CheckpointRing() {
    {
        const std::lock_guard lock(mutex_);
        stops_ = true;
    }
    changed_.notify_all();
    if (worker_.joinable()) worker_.join();
}

/// Returns the lock once no packing is in progress. Drops a checkpoint that is on its way from the GPU.
std::unique_lock<std::mutex> CheckpointRing::whenIdle() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stage_ != Stage::packing; });
    stage_ = Stage::idle;
    return lock;
}

void CheckpointRing::clear(CheckpointTaker taker, bool keeps) {
    const auto lock = whenIdle();
    taker_ = std::move(taker);
    keeps_ = keeps;
    checkpoints_.clear();
    reference_ = fresh_ = {};
    history_.clear();
    historyKept_ = 0;
    fault_.clear();
    last_ = -std::numeric_limits<double>::infinity();
    historyTo_ = 0;
}

void CheckpointRing::giveTo(CheckpointTaker taker) {
    const auto lock = whenIdle();
    taker_ = std::move(taker);
}

bool CheckpointRing::due(double time, double period) {
    if (std::abs(time - last_) < period) return false;
    const std::lock_guard lock(mutex_);
    return stage_ == Stage::idle && fault_.empty() && !covers(time, period);
}

/// True if a stored checkpoint is less than a period away.
bool CheckpointRing::covers(double time, double period) const {
    if (!keeps_) return false;
    const auto after = std::partition_point(checkpoints_.begin(), checkpoints_.end(),
                                            [&](const KeptCheckpoint& moment) { return moment.time <= time; });
    if (after != checkpoints_.end() && after->time - time < period) return true;
    return after != checkpoints_.begin() && time - std::prev(after)->time < period;
}

void CheckpointRing::begun(double time, size_t historyTo) {
    last_ = time;
    historyTo_ = std::max(historyTo_, historyTo);
    const std::lock_guard lock(mutex_);
    stage_ = Stage::onGpu;
    if (!worker_.joinable()) worker_ = std::thread([this] { work(); });
}

void CheckpointRing::update() {
    {
        const std::lock_guard lock(mutex_);
        if (stage_ != Stage::onGpu || !capture_.arrived()) return;
        stage_ = Stage::packing;
    }
    changed_.notify_all();
}

void CheckpointRing::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return stops_ || stage_ == Stage::packing; });
        if (stops_) return;
        lock.unlock();
        std::string fault;
        KeptCheckpoint made;
        try {
            made = packed();
            give(made);
        } catch (const std::exception& failure) {
            fault = std::string("You can no longer go back in this attempt: ") + failure.what();
        }
        lock.lock();
        fault_ = fault;
        const bool kept = fault.empty() && (keeps_ || checkpoints_.empty());
        const auto after = std::partition_point(checkpoints_.begin(), checkpoints_.end(),
                                                [&](const KeptCheckpoint& moment) { return moment.time <= made.time; });
        if (kept) checkpoints_.insert(after, std::move(made));
        thinOut();
        stage_ = Stage::idle;
        changed_.notify_all();
    }
}

/// Packs the checkpoint that arrived; runs on the worker, while the stage is `packing`.
CheckpointRing::KeptCheckpoint CheckpointRing::packed() {
    capture_.take(fresh_);
    addHistory();
    KeptCheckpoint made{fresh_.step, fresh_.time, fresh_.historyTo, {}};
    fresh_.history.clear();
    seal(fresh_);
    if (reference_.bytes.empty())
        reference_ = fresh_;
    else
        made.packed = pack(fresh_, reference_);
    return made;
}

/// Adds the hand's steps that were not yet known.
void CheckpointRing::addHistory() {
    if (!keeps_ || fresh_.historyTo <= historyKept_) return;
    if (fresh_.historyFrom != historyKept_)
        throw RuntimeFault("a checkpoint came without the torch's steps before it; expected all of them");
    history_.insert(history_.end(), fresh_.history.begin(), fresh_.history.end());
    historyKept_ = fresh_.historyTo;
}

void CheckpointRing::give(const KeptCheckpoint& moment) const {
    if (!taker_) return;
    const std::vector<std::byte> first = moment.packed.empty() ? pack(reference_) : std::vector<std::byte>();
    taker_({moment.step, moment.time, moment.packed.empty() ? first : moment.packed});
}

size_t CheckpointRing::bytesNow() const {
    size_t sum = capture_.bytes() + sizeOf(fresh_) + sizeOf(reference_) + history_.capacity();
    for (const KeptCheckpoint& moment : checkpoints_)
        sum += moment.packed.capacity() + sizeof(KeptCheckpoint);
    return sum;
}

/// Drops, between the first and the newest checkpoint, the one with the smallest gap for its age.
void CheckpointRing::thinOut() {
    while (bytesNow() > limits_.bytes && checkpoints_.size() > kNewest + 2) {
        const double now = checkpoints_.back().time;
        size_t least = 1;
        double leastShare = std::numeric_limits<double>::infinity();
        for (size_t i = 1; i + kNewest < checkpoints_.size(); ++i) {
            const double share = (checkpoints_[i + 1].time - checkpoints_[i - 1].time) / (now - checkpoints_[i].time);
            if (share >= leastShare) continue;
            leastShare = share;
            least = i;
        }
        checkpoints_.erase(checkpoints_.begin() + static_cast<std::ptrdiff_t>(least));
    }
}

/// The checkpoint with all steps of the hand from the first on.
Checkpoint CheckpointRing::whole(size_t number) const {
    const KeptCheckpoint& moment = checkpoints_[number];
    Checkpoint made = moment.packed.empty() ? reference_ : unpack(moment.packed, reference_);
    if (historyKept_ > 0) {
        const size_t bytes = history_.size() / historyKept_ * moment.historyTo;
        made.history.assign(history_.begin(), history_.begin() + static_cast<std::ptrdiff_t>(bytes));
    }
    made.historyFrom = 0;
    made.historyTo = moment.historyTo;
    made.historyTime = 0;
    seal(made);
    return made;
}

std::optional<Checkpoint> CheckpointRing::before(double time) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stage_ != Stage::packing; });
    const auto after = std::find_if(checkpoints_.begin(), checkpoints_.end(),
                                    [&](const KeptCheckpoint& moment) { return moment.time > time; });
    if (after == checkpoints_.begin()) return std::nullopt;
    return whole(static_cast<size_t>(after - checkpoints_.begin()) - 1);
}

void CheckpointRing::branch(size_t step) {
    const auto lock = whenIdle();
    std::erase_if(checkpoints_, [&](const KeptCheckpoint& moment) { return moment.step > step; });
    if (checkpoints_.empty()) reference_ = {};
    last_ = checkpoints_.empty() ? -std::numeric_limits<double>::infinity() : checkpoints_.back().time;
    historyTo_ = checkpoints_.empty() ? 0 : checkpoints_.back().historyTo;
    if (historyKept_ > historyTo_) history_.resize(history_.size() / historyKept_ * historyTo_);
    historyKept_ = std::min(historyKept_, historyTo_);
}

size_t CheckpointRing::count() {
    const std::lock_guard lock(mutex_);
    return checkpoints_.size();
}

size_t CheckpointRing::bytes() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stage_ != Stage::packing; });
    return bytesNow();
}

std::string CheckpointRing::fault() {
    const std::lock_guard lock(mutex_);
    return fault_;
}

} // namespace meltpool
