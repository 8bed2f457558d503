// The feel of the arc.
#include "xr/haptics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool::xr {

namespace {

constexpr float kRenewal = 0.05f; // s: outlives a frame at 20 Hz, so the hum has no gaps, and ends soon after the last
constexpr float kKnockDuration = 0.03f;
constexpr float kKnockFrequency = 60.0f;
constexpr float kHardKnock = 0.2f;      // m/s from which a knock is felt in full
constexpr float kHumFrequency = 170.0f; // near the resonance of common voice-coil motors
constexpr float kLongArcFrequency = 90.0f;
constexpr double kStutterRate = 9.0; // 1/s

HapticPulse knock(const TipState& tip) {
    const float hardness = std::clamp(tip.approachSpeed / kHardKnock, 0.0f, 1.0f);
    return {0.4f + 0.6f * hardness, kKnockFrequency, kKnockDuration};
}

HapticPulse hum(const TipState& tip) {
    const float power = std::clamp(tip.power, 0.0f, 1.0f);
    const float length = tip.steadyDistance > 0 ? std::max(tip.distance, 0.0f) / tip.steadyDistance : 1.0f;
    const float stretch = std::clamp((length - 1.0f) / (kBreakingDistance - 1.0f), 0.0f, 1.0f);
    HapticPulse pulse{(0.15f + 0.45f * power) * (1.0f - 0.6f * stretch),
                      kHumFrequency + (kLongArcFrequency - kHumFrequency) * stretch, kRenewal};
    const bool gap = std::fmod(tip.time * kStutterRate, 1.0) >= 0.5;
    if (length >= kBreakingDistance && gap) pulse = {};
    return pulse;
}

} // namespace

HapticPulse feel(const TipState& tip) {
    if (tip.touchBegan) return knock(tip);
    if (tip.arc && tip.power > 0) return hum(tip);
    return {};
}

void synthesize(const HapticPulse& pulse, float sampleRate, double phase, std::span<float> samples) {
    const double step = 2.0 * std::numbers::pi * static_cast<double>(pulse.frequency) / static_cast<double>(sampleRate);
    for (float& sample : samples) {
        sample = pulse.amplitude * static_cast<float>(std::sin(phase));
        phase += step;
    }
}

} // namespace meltpool::xr
