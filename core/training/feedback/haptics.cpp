// Computes the feel of the arc.
#include "core/training/feedback/haptics.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kRenewal = 0.05f; // s: longer than a frame at 20 Hz, so that the hum has no gaps, and short enough to
                                  // end soon after the last frame
constexpr float kKnockFrequency = 60.0f;
constexpr float kDullFrequency = 35.0f; // frequency of a knock on liquid metal
constexpr float kDullness = 0.6f;       // share of a knock that liquid metal absorbs
constexpr float kHardKnock = 0.2f;      // m/s of a knock at full strength
constexpr float kHumFrequency = 170.0f; // near the resonance of common voice-coil motors
constexpr float kLongArcFrequency = 90.0f;
constexpr float kPoolDrop = 20.0f; // Hz by which a pool lowers the hum
constexpr float kLeastShorts = 20; // 1/s of an open arc: fewer are no stutter
constexpr float kBuzzFrequency = 45.0f;
constexpr float kBuzzAmplitude = 0.8f;

Vibration knock(const TipFeel& tip) {
    const float hardness = std::clamp(tip.touchSpeed / kHardKnock, 0.0f, 1.0f);
    const float liquid = tip.arc.liquid;
    return {(0.4f + 0.6f * hardness) * (1.0f - kDullness * liquid),
            kKnockFrequency + (kDullFrequency - kKnockFrequency) * liquid,
            static_cast<float>(kKnockDuration - tip.sinceTouch)};
}

Vibration hum(const ArcState& arc) {
    return {(0.15f + 0.45f * arc.share) * (1.0f - 0.6f * arc.stretch),
            kHumFrequency + (kLongArcFrequency - kHumFrequency) * arc.stretch - kPoolDrop * arc.liquid, kRenewal};
}

/// The pulse for the first half of each beat, silence for the second.
Vibration stutter(const Vibration& pulse, double beats) {
    return std::fmod(beats, 1.0) < 0.5 ? pulse : Vibration{};
}

/// Beats of the bridging drops since the start.
double shortBeats(const TipFeel& tip) {
    return tip.arc.shorts > 0 ? tip.shorts / kShortsPerPulse : tip.time * kTouchRate;
}

} // namespace

Vibration feel(const TipFeel& tip) {
    if (tip.sinceTouch < kKnockDuration) return knock(tip);
    switch (tip.arc.action) {
    case ArcAction::out:
        break;
    case ArcAction::striking:
        return hum(tip.arc);
    case ArcAction::burning:
        return tip.arc.shorts < kLeastShorts ? hum(tip.arc) : stutter(hum(tip.arc), shortBeats(tip));
    case ArcAction::shorting:
        return stutter(hum(tip.arc), shortBeats(tip));
    case ArcAction::breaking:
        return stutter(hum(tip.arc), tip.time * kBreakRate);
    case ArcAction::stubbed:
        return {kBuzzAmplitude, kBuzzFrequency, kRenewal};
    }
    return {};
}

} // namespace meltpool
