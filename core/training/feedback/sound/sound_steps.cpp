#include "core/training/feedback/sound/sound_steps.hpp"

namespace meltpool {

bool SoundFeed::push(const SoundStep& step) {
    const size_t pushed = pushed_.load(std::memory_order_relaxed);
    if (pushed - popped_.load(std::memory_order_acquire) >= kRoom) return false;
    steps_[pushed % kRoom] = step;
    pushed_.store(pushed + 1, std::memory_order_release);
    return true;
}

bool SoundFeed::pop(SoundStep& step) {
    const size_t popped = popped_.load(std::memory_order_relaxed);
    if (popped == pushed_.load(std::memory_order_acquire)) return false;
    step = steps_[popped % kRoom];
    popped_.store(popped + 1, std::memory_order_release);
    return true;
}

size_t SoundFeed::waiting() const {
    return pushed_.load(std::memory_order_acquire) - popped_.load(std::memory_order_relaxed);
}

void SoundSteps::hear(const SoundStep& step) {
    if (chips_ == 0) {
        captions_.step(step);
        feed_.push(step);
        return;
    }
    SoundStep chipped = step;
    chipped.chips = chips_;
    chips_ = 0;
    captions_.step(chipped);
    feed_.push(chipped);
}

} // namespace meltpool
