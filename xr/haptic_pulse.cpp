#include "xr/haptic_pulse.hpp"

#include <cmath>
#include <numbers>

namespace meltpool::xr {

void synthesize(const HapticPulse& pulse, float sampleRate, double phase, std::span<float> samples) {
    const double step = 2.0 * std::numbers::pi * static_cast<double>(pulse.frequency) / static_cast<double>(sampleRate);
    for (float& sample : samples) {
        sample = pulse.amplitude * static_cast<float>(std::sin(phase));
        phase += step;
    }
}

} // namespace meltpool::xr
