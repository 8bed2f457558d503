#include "xr/hold.hpp"

#include <cmath>

namespace meltpool::xr {

bool holdsByAim(const Pose& grip, const Pose& aim) {
    return glm::dot(grip.forward(), aim.forward()) < std::cos(kGreatestLean);
}

glm::quat holdRotation(const Pose& grip, const Pose& aim) {
    if (!holdsByAim(grip, aim)) return {1, 0, 0, 0};
    return glm::normalize(glm::conjugate(grip.orientation) * aim.orientation);
}

} // namespace meltpool::xr
