// What the hand feels: vibration as a pure function of what happens at the torch's tip, never of the button.
#pragma once

#include <cstdint>
#include <span>

namespace meltpool::xr {

/// What happens at the tip in this frame.
struct TipState {
    double time = 0;          ///< seconds since the lesson began; carries the rhythm
    bool arc = false;         ///< heat flows
    float power = 0;          ///< 0..1 of the process's largest
    float distance = 0;       ///< m from the tip to the metal; 0 or less: touching
    float steadyDistance = 0; ///< m, the distance that the process wants; 0: any distance is right
    float approachSpeed = 0;  ///< m/s towards the metal at the moment of touching, 0 away from it
    bool touchBegan = false;  ///< the tip met the metal in this frame
};

/// One vibration, to be renewed every frame while it lasts.
struct HapticPulse {
    float amplitude = 0; ///< 0..1; 0: silence
    float frequency = 0; ///< Hz; 0: the device's own choice
    float duration = 0;  ///< seconds
    bool silent() const { return amplitude <= 0.0f; }
    bool operator==(const HapticPulse&) const = default;
};

/// Hum with the arc (amplitude grows with power and as the distance nears the right one, frequency falls as the arc
/// gets long), stutter (amplitude cut 9 times a second) where the tip is so far off that the arc would break, a knock
/// when the tip meets the metal. A touch outweighs the hum. Nothing happens at the tip: silence.
HapticPulse feel(const TipState& tip);

/// Samples in [-1, 1] of the pulse as a sine that starts at `phase` (radians), for devices that play PCM.
void synthesize(const HapticPulse& pulse, float sampleRate, double phase, std::span<float> samples);

/// Where the arc of this process would break, as a multiple of the steady distance.
constexpr float kBreakingDistance = 2.5f;

} // namespace meltpool::xr
