// Defines one vibration of a controller, and its PCM samples.
#pragma once

#include <span>

namespace meltpool::xr {

/// Lasts `duration` from the start of its playing; the next pulse on that controller replaces it.
struct HapticPulse {
    float amplitude = 0; ///< 0..1; 0: silence
    float frequency = 0; ///< Hz; 0: the device's own choice
    float duration = 0;  ///< seconds
    bool silent() const { return amplitude <= 0.0f; }
    bool operator==(const HapticPulse&) const = default;
};

/// Samples in [-1, 1] of the pulse as a sine that starts at `phase` (radians), for devices that play PCM.
/// `sampleRate` in Hz.
void synthesize(const HapticPulse& pulse, float sampleRate, double phase, std::span<float> samples);

} // namespace meltpool::xr
