#include "app/headset/again_hold.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

void AgainHold::update(bool pulled, bool free, double elapsed) {
    constexpr double kLongestFrame = 0.1; // s
    const bool begins = !std::exchange(pulled_, pulled);
    const double before = held_;
    held_ = pulled && free && (begins || held_ > 0) ? held_ + std::min(elapsed, kLongestFrame) : 0;
    asked_ = before < kHold && held_ >= kHold;
}

} // namespace meltpool
