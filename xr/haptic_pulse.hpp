// One vibration of a controller, and the PCM samples of it.
#pragma once

#include <span>

namespace meltpool::xr {

/// Lasts for `duration` from when it is played; the next one on the same controller replaces it.
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
