#include "core/base/work_meter.hpp"

#include <algorithm>
#include <ctime>

namespace meltpool {

namespace {

/// Processor time of this thread, s.
double threadSeconds() {
#if defined(CLOCK_THREAD_CPUTIME_ID)
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
#else
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
#endif
}

/// Cost of reading the clock, s.
double lookSeconds() {
    using Clock = std::chrono::steady_clock;
    constexpr int kLooks = 100, kTries = 20;
    Clock::duration least = Clock::duration::max();
    for (int i = 0; i < kTries; ++i) {
        const Clock::time_point start = Clock::now();
        for (int look = 1; look < kLooks; ++look)
            static_cast<void>(Clock::now());
        least = std::min(least, Clock::now() - start);
    }
    return std::chrono::duration<double>(least).count() / kLooks;
}

/// True if the thread may sleep in this place.
bool sleeps(WorkPlace place) {
    return place == WorkPlace::runtime || place == WorkPlace::waiting;
}

} // namespace

WorkCosts& WorkCosts::operator+=(const WorkCosts& other) {
    cpuSeconds += other.cpuSeconds;
    allocations += other.allocations;
    stalls += other.stalls;
    if (other.stalls > 0) lastStall = other.lastStall;
    return *this;
}

void WorkMeter::begin() {
    spent_ = {};
    cpu_ = {};
    window_ = {};
    looks_ = {};
    stalls_ = 0;
    ownAllocations_ = 0;
    elsewhere_ = {};
    allocationsBefore_ = countAllocations_();
    place_ = WorkPlace::own;
    current_ = this;
    windowCpuSince_ = threadSeconds();
    windowSince_ = since_ = Clock::now();
}

void WorkMeter::end() {
    if (current_ != this) return;
    change(place_);
    closeWindow();
    current_ = nullptr;
}

void WorkMeter::change(WorkPlace next) {
    const Clock::time_point now = Clock::now();
    const auto here = static_cast<size_t>(place_);
    const double seconds = std::chrono::duration<double>(now - since_).count();
    spent_[here] += seconds;
    window_[here] += seconds;
    ++looks_[here];
    const std::uint64_t allocations = countAllocations_();
    if (place_ == WorkPlace::own) ownAllocations_ += allocations - allocationsBefore_;
    allocationsBefore_ = allocations;
    since_ = now;
    const bool sleep = place_ != next && (sleeps(place_) || sleeps(next));
    if (sleep || now - windowSince_ >= kWindow) closeWindow();
    place_ = next;
}

void WorkMeter::closeWindow() {
    const double now = threadSeconds();
    for (size_t place = 0; place < kWorkPlaces; ++place)
        cpu_[place] += std::min(window_[place], now - windowCpuSince_);
    window_ = {};
    windowCpuSince_ = now;
    windowSince_ = since_ = Clock::now(); // excludes the cost of reading the clock
}

double WorkMeter::cpuSeconds(WorkPlace place) const {
    static const double look = lookSeconds();
    const auto here = static_cast<size_t>(place);
    return std::max(cpu_[here] - looks_[here] * look, 0.0);
}

WorkElsewhere WorkMeter::forAnother() const {
    return {cpuSeconds(WorkPlace::own) + cpuSeconds(WorkPlace::runtime) + elsewhere_.cpuSeconds,
            ownAllocations_ + elsewhere_.allocations};
}

void WorkMeter::add(const WorkElsewhere& other) {
    elsewhere_.cpuSeconds += other.cpuSeconds;
    elsewhere_.allocations += other.allocations;
}

} // namespace meltpool
