#include "core/training/feedback/sound/short_circuits.hpp"

#include "core/weld/process/weld_constants.hpp"

namespace meltpool {

namespace {

/// A pseudo-random number -1..1 for each count.
double scatter(std::uint64_t count) {
    // The finaliser of SplitMix64 (Steele, Lea, Flood 2014): neighbouring counts give unrelated numbers.
    std::uint64_t mixed = (count + 1) * 0x9E3779B97F4A7C15ULL;
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9ULL;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBULL;
    mixed ^= mixed >> 31;
    return static_cast<double>(mixed >> 11) * 0x1p-52 - 1;
}

} // namespace

bool ignitesAgain(ArcAction action) {
    return action == ArcAction::shorting || action == ArcAction::burning || action == ArcAction::breaking;
}

void ShortCircuits::step(const ArcState& arc, double seconds, bool controlled) {
    listed_ = 0;
    const auto rate = static_cast<double>(arc.shorts);
    if (rate <= 0 || seconds <= 0 || !ignitesAgain(arc.action)) return;
    const float current = controlled ? static_cast<float>(kControlledBreakCurrent) : arc.current;
    double left = rate * seconds;
    double passed = 0;
    while (way_ + left >= next_) {
        passed += next_ - way_;
        left -= next_ - way_;
        way_ = 0;
        ++count_;
        next_ = controlled ? 1 : 1 + kUnevenness * scatter(count_);
        if (listed_ < kMost) last_[listed_++] = {static_cast<float>(passed / rate), arc.voltage * current};
    }
    way_ += left;
}

} // namespace meltpool
