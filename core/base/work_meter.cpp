#include "core/base/work_meter.hpp"

#include <algorithm>
#include <ctime>

namespace meltpool {

namespace {

/// The processor's time of this thread, s.
double threadSeconds() {
#if defined(CLOCK_THREAD_CPUTIME_ID)
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
#else
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
#endif
}

/// What a look at both clocks takes of it, s: half a microsecond, since the system has to be asked.
double lookSeconds() {
    constexpr int kLooks = 100, kTries = 20;
    double least = 1;
    for (int i = 0; i < kTries; ++i) {
        const double start = threadSeconds();
        for (int look = 0; look < kLooks; ++look) {
            static_cast<void>(std::chrono::steady_clock::now());
            threadSeconds();
        }
        least = std::min(least, (threadSeconds() - start) / kLooks);
    }
    return least;
}

} // namespace

void WorkMeter::begin() {
    spent_ = {};
    stalls_ = 0;
    ownAllocations_ = 0;
    allocationsBefore_ = allocationsHere;
    ownCpu_ = 0;
    ownParts_ = 0;
    place_ = WorkPlace::own;
    since_ = Clock::now();
    cpuSince_ = threadSeconds();
    current_ = this;
}

void WorkMeter::end() {
    if (current_ != this) return;
    change(place_);
    current_ = nullptr;
}

void WorkMeter::change(WorkPlace next) {
    const Clock::time_point now = Clock::now();
    const double cpuNow = threadSeconds();
    spent_[static_cast<size_t>(place_)] += std::chrono::duration<double>(now - since_).count();
    if (place_ == WorkPlace::own) {
        ownAllocations_ += allocationsHere - allocationsBefore_;
        ownCpu_ += cpuNow - cpuSince_;
        ++ownParts_;
    }
    since_ = now;
    cpuSince_ = cpuNow;
    allocationsBefore_ = allocationsHere;
    place_ = next;
}

double WorkMeter::ownCpuSeconds() const {
    static const double look = lookSeconds();
    return std::max(ownCpu_ - ownParts_ * look, 0.0);
}

} // namespace meltpool
