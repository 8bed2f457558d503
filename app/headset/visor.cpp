#include "app/headset/visor.hpp"

#include <algorithm>

namespace meltpool {

float Visor::transmission(const HeadsetParameters& parameters) const {
    if (!parameters.visor) return 1.0f;
    const auto clear = static_cast<float>(std::clamp((sinceHeat_ - kHold) / kClearing, 0.0, 1.0));
    return parameters.visorShade + (1.0f - parameters.visorShade) * clear;
}

} // namespace meltpool
