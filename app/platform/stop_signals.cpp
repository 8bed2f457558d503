#include "app/platform/stop_signals.hpp"

#include <atomic>
#include <cstdlib>

namespace meltpool {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLook(50); ///< between two checks of the signals

constexpr long long kSecondWish = 300; ///< ms after the first; an earlier one is its duplicate from another sender

long long now() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now().time_since_epoch()).count();
}

std::atomic<long long> askedAt{0}; ///< ms of Clock; 0: not asked
static_assert(std::atomic<long long>::is_always_lock_free, "a signal handler must not wait for a lock");

std::atomic<const char*> answerToFirst{nullptr};

[[noreturn]] void endAtOnce() {
    std::_Exit(1);
}

} // namespace

void StopSignals::wish(bool interrupt) {
    long long first = 0;
    if (askedAt.compare_exchange_strong(first, now())) {
        if (const char* answer = answerToFirst) say(answer);
        return;
    }
    if (!interrupt || now() - first < kSecondWish) return;
    say("\nmeltpool: ended at once; what was written up to here is kept\n");
    endAtOnce();
}

StopSignals::StopSignals(const char* answer) {
    askedAt = 0;
    answerToFirst = answer;
    catchSignals();
}

StopSignals::~StopSignals() {
    answerToFirst = nullptr;
    {
        const std::lock_guard lock(mutex_);
        granted_ = true;
    }
    changed_.notify_all();
    if (watcher_.joinable()) watcher_.join();
    leaveSignals();
}

bool StopSignals::asked() {
    return askedAt != 0;
}

void StopSignals::endAfter(std::chrono::milliseconds patience, std::function<void()> last) {
    const std::lock_guard lock(mutex_);
    patience_ = patience;
    last_ = std::move(last);
    if (!watcher_.joinable()) watcher_ = std::thread([this] { watch(); });
}

void StopSignals::grantStop() {
    // Blocks forever if the watcher is ending the process, because it holds the lock.
    const std::lock_guard lock(mutex_);
    granted_ = true;
}

void StopSignals::watch() {
    std::unique_lock lock(mutex_);
    while (!granted_ && !asked())
        changed_.wait_for(lock, kLook);
    changed_.wait_for(lock, patience_, [this] { return granted_; });
    if (granted_) return;
    if (last_) last_();
    endAtOnce();
}

} // namespace meltpool
