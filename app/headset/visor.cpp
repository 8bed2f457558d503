#include "app/headset/visor.hpp"

#include <algorithm>

namespace meltpool {

void Visor::wear(const HeadsetParameters& parameters, bool kelvin, LookParameters& look) const {
    const float dark = darkness(parameters);
    if (dark <= 0) return;
    if (kelvin) {
        constexpr float kClearShade = 3; // light state of an auto-darkening visor (EN 379)
        look.visorShade = kClearShade + (parameters.visorShade - kClearShade) * dark;
    } else {
        look.exposure *= 1 + (parameters.visorShare - 1) * dark;
    }
}

float Visor::darkness(const HeadsetParameters& parameters) const {
    if (!parameters.visor) return 0;
    return 1 - static_cast<float>(std::clamp((sinceHeat_ - kHold) / kClearing, 0.0, 1.0));
}

} // namespace meltpool
