#include "app/meter/frame_meter.hpp"

#include <algorithm>

namespace meltpool {

void FrameMeter::begin() {
    sum_ = {};
    allocations_ = 0;
    resume();
}

void FrameMeter::resume() {
    running_ = true;
    work_.begin();
}

void FrameMeter::take() {
    if (!running_) return;
    running_ = false;
    work_.end();
    for (const WorkPlace place : {WorkPlace::driver, WorkPlace::runtime, WorkPlace::waiting})
        sum_[static_cast<size_t>(place)] += work_.seconds(place) * 1000;
    sum_[static_cast<size_t>(WorkPlace::own)] += work_.ownCpuSeconds() * 1000;
    totals_.stalls += work_.stalls();
    if (work_.stalls() > 0) totals_.lastStall = work_.lastStall();
    allocations_ += work_.ownAllocations();
}

void FrameMeter::pause() {
    take();
}

void FrameMeter::end() {
    take();
    last_ = sum_;
    own_[totals_.frames % kKept] = static_cast<float>(lastMs(WorkPlace::own));
    ++totals_.frames;
    totals_.allocations += allocations_;
    if (allocations_ > 0) ++totals_.framesThatAllocated;
}

void FrameMeter::restart() {
    totals_ = {};
}

double FrameMeter::medianOwnMs() const {
    const size_t kept = std::min<size_t>(totals_.frames, kKept);
    if (kept == 0) return 0;
    std::array<float, kKept> sorted = own_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(kept / 2);
    std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(kept));
    return static_cast<double>(*middle);
}

double FrameMeter::leastOwnMs() const {
    const size_t kept = std::min<size_t>(totals_.frames, kKept);
    return kept == 0
               ? 0
               : static_cast<double>(*std::min_element(own_.begin(), own_.begin() + static_cast<std::ptrdiff_t>(kept)));
}

} // namespace meltpool
