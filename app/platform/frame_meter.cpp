#include "app/platform/frame_meter.hpp"

#include <algorithm>

namespace meltpool {

void FrameMeter::begin() {
    sum_ = {};
    cpu_ = {};
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
    for (size_t place = 0; place < kWorkPlaces; ++place)
        sum_[place] += work_.seconds(static_cast<WorkPlace>(place)) * 1000;
    const double own = work_.cpuSeconds(WorkPlace::own) * 1000;
    // During a call of the runtime this thread's own time goes into waking the worker and being woken.
    const double runtime =
        (work_.cpuSeconds(WorkPlace::runtime) + work_.cpuSeconds(WorkPlace::waiting) + work_.elsewhere().cpuSeconds) *
        1000;
    cpu_[static_cast<size_t>(FrameWork::own)] += own;
    cpu_[static_cast<size_t>(FrameWork::runtime)] += runtime;
    cpu_[static_cast<size_t>(FrameWork::outside)] += own + runtime;
    totals_.stalls += work_.stalls();
    if (work_.stalls() > 0) totals_.lastStall = work_.lastStall();
    allocations_ += work_.ownAllocations() + work_.elsewhere().allocations;
}

void FrameMeter::add(const WorkCosts& other) {
    const double own = other.cpuSeconds * 1000;
    cpu_[static_cast<size_t>(FrameWork::own)] += own;
    cpu_[static_cast<size_t>(FrameWork::outside)] += own;
    totals_.stalls += other.stalls;
    if (other.stalls > 0) totals_.lastStall = other.lastStall;
    allocations_ += other.allocations;
}

void FrameMeter::pause() {
    take();
}

void FrameMeter::end() {
    take();
    last_ = sum_;
    for (size_t work = 0; work < kFrameWorks; ++work)
        kept_[work][totals_.frames % kKept] = static_cast<float>(cpu_[work]);
    ++totals_.frames;
    totals_.allocations += allocations_;
    if (allocations_ > 0) ++totals_.framesThatAllocated;
}

void FrameMeter::restart() {
    totals_ = {};
}

size_t FrameMeter::kept() const {
    return std::min<size_t>(totals_.frames, kKept);
}

double FrameMeter::lastMs(FrameWork work) const {
    return totals_.frames == 0 ? 0 : static_cast<double>(keptOf(work)[(totals_.frames - 1) % kKept]);
}

double FrameMeter::medianMs(FrameWork work) const {
    if (kept() == 0) return 0;
    Samples sorted = keptOf(work);
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(kept() / 2);
    std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(kept()));
    return static_cast<double>(*middle);
}

double FrameMeter::leastMs(FrameWork work) const {
    const Samples& all = keptOf(work);
    if (kept() == 0) return 0;
    return static_cast<double>(*std::min_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept())));
}

} // namespace meltpool
