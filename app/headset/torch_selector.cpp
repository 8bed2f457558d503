#include "app/headset/torch_selector.hpp"

#include "core/base/words.hpp"

#include <algorithm>

namespace meltpool {

void TorchSelector::choose(bool wanted, std::span<const xr::TrackerInput> trackers, double elapsed) {
    wanted_ = wanted;
    const size_t before = tracker_;
    // The tracker in use stays chosen as long as it is tracked.
    if (tracker_ >= trackers.size() || !trackers[tracker_].tracked)
        for (size_t i = trackers.size(); i-- > 0;)
            if (trackers[i].tracked) tracker_ = i;
    visible_ = wanted && tracker_ < trackers.size() && trackers[tracker_].tracked;
    lost_ = visible_ ? 0 : lost_ + elapsed;
    seen_ = wanted && (seen_ || visible_);
    const TorchHolder now = visible_ || (seen_ && lost_ < kPatience) ? TorchHolder::tracker : TorchHolder::hand;
    changed_ = now != holder_ || (now == TorchHolder::tracker && tracker_ != before);
    holder_ = now;
}

void TorchSelector::update(bool wanted, const xr::HandInput& hand, std::span<const xr::TrackerInput> trackers,
                           double elapsed) {
    choose(wanted, trackers, elapsed);
    torch_ = hand;
    if (holder_ == TorchHolder::tracker) {
        const xr::TrackerInput& tracker = trackers[tracker_];
        torch_.present = true;
        torch_.tracked = tracker.tracked;
        torch_.grip = torch_.hold = tracker.pose;
        torch_.trigger = std::max(tracker.trigger, hand.trigger);
    }
}

std::string_view TorchSelector::warning() const {
    if (!wanted_ || visible_) return {};
    if (!seen_) return phrase("headset.torch.no_tracker");
    if (holder_ == TorchHolder::tracker) return phrase("headset.torch.tracker_lost");
    return phrase("headset.torch.controller_instead");
}

} // namespace meltpool
