#include "core/training/feedback/sound/captions.hpp"

#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kMemory = 0.4;      // s over which the evenness of short circuits is judged
constexpr double kUneven = 0.35;     // standard deviation of their rate over its mean
constexpr double kLeastRate = 10;    // 1/s, least rate that is called short circuits
constexpr double kForgotten = 5;     // 1/s, weighted rate below which the last short circuits no longer count
constexpr float kLongArc = 0.5F;     // stretch
constexpr float kFastDrops = 100;    // 1/s: a hum
constexpr double kMomentStays = 1.0; // s that a caption of ticks and strokes stays

} // namespace

/// Mean and square of the rate over the last kMemory, from the first short circuit on.
void Captions::followRate(const SoundStep& step) {
    const bool wire = step.process != nullptr && step.process->feedsWire;
    const double rate = wire && ignitesAgain(step.arc.action) ? static_cast<double>(step.arc.shorts) : 0;
    if (rate < kForgotten && mean_ < kForgotten) {
        mean_ = square_ = weight_ = 0;
        return;
    }
    const double share = 1 - std::exp(-step.seconds / kMemory);
    weight_ += (1 - weight_) * share;
    mean_ += (rate - mean_) * share;
    square_ += (rate * rate - square_) * share;
}

std::string_view Captions::keyOf(const SoundStep& step) const {
    const SoundLevels& levels = state_.levels();
    if (levels.stub > 0) return "cue.heard.wire_stubs";
    if (levels.hiss > 0 && step.arc.stretch > kLongArc) return "cue.heard.long_arc";
    const double mean = weight_ > 0 ? mean_ / weight_ : 0;
    if (mean > kLeastRate && step.arc.burns()) {
        const double spread = std::sqrt(std::max(square_ / weight_ - mean * mean, 0.0));
        return spread > kUneven * mean ? "cue.heard.shorts_uneven" : "cue.heard.shorts_even";
    }
    if (levels.crackle > 0) return "cue.heard.electrode_crackles";
    if (levels.buzz > 0) return "cue.heard.current_buzzes";
    if (levels.drops > 0) return levels.dropRate >= kFastDrops ? "cue.heard.drops_hum" : "cue.heard.drops_fall";
    if (levels.hiss > 0) return "cue.heard.arc_hisses";
    if (levels.roar > 0) return "cue.heard.flame_roars";
    if (levels.scratch > 0) return "cue.heard.electrode_scratches";
    if (chips_ > 0) return "cue.heard.slag_chipped";
    if (state_.gasAlone()) return "cue.heard.gas_flows";
    if (ticks_ > 0) return "cue.heard.metal_ticks";
    return {};
}

std::string_view Captions::text() const {
    return told_.empty() ? std::string_view() : phrase(told_);
}

void Captions::step(const SoundStep& step) {
    state_.step(step);
    followRate(step);
    chips_ = step.chips > 0 ? kMomentStays : std::max(chips_ - step.seconds, 0.0);
    ticks_ = state_.ticks() > 0 ? kMomentStays : std::max(ticks_ - step.seconds, 0.0);
    const std::string_view heard = keyOf(step);
    since_ = heard == next_ ? since_ + step.seconds : 0;
    next_ = heard;
    if (since_ >= (heard.empty() ? kStays : kPatience)) told_ = heard;
}

} // namespace meltpool
