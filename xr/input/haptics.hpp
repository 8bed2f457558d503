// What the hand feels: vibration as a pure function of what happens at the torch's tip, never of the button.
#pragma once

#include "core/weld/process/tip_state.hpp"

#include <limits>
#include <span>

namespace meltpool::xr {

/// What happens at the tip in this frame.
struct TipFeel {
    double time = 0; ///< seconds; carries the rhythm
    TipState state;
    double sinceTouch = std::numeric_limits<double>::infinity(); ///< seconds since the tip met the metal
    float touchSpeed = 0;                                        ///< m/s, at that moment
};

/// One vibration, to be renewed every frame while it lasts.
struct HapticPulse {
    float amplitude = 0; ///< 0..1; 0: silence
    float frequency = 0; ///< Hz; 0: the device's own choice
    float duration = 0;  ///< seconds
    bool silent() const { return amplitude <= 0.0f; }
    bool operator==(const HapticPulse&) const = default;
};

/// Hum with arc or flame (amplitude grows with the power that arrives and sinks with a long arc, frequency falls with a
/// long arc and over liquid metal); stutter of kBreakRate a second where the arc is about to break and kShortRate where
/// drops bridge it; a rough buzz where the wire stubs; a knock when the tip meets the metal, dull on liquid, which
/// outweighs the rest while it lasts. Nothing happens at the tip: silence.
HapticPulse feel(const TipFeel& tip);

constexpr double kBreakRate = 9;  ///< 1/s
constexpr double kShortRate = 20; ///< 1/s; real ones, 50 to 200, would be lost between the frames

/// How long a touch is felt, s.
constexpr double kKnockDuration = 0.03;

/// Samples in [-1, 1] of the pulse as a sine that starts at `phase` (radians), for devices that play PCM.
void synthesize(const HapticPulse& pulse, float sampleRate, double phase, std::span<float> samples);

} // namespace meltpool::xr
