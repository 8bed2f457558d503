#include "core/weld/process/tip_touch.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kLately = 0.05;  ///< s
constexpr float kLetGo = 0.5e-3F; ///< m off the metal before the next touch is a new one

} // namespace

void TipTouch::update(float radius, const SurfaceDistance& metal, const glm::vec3& velocity, double elapsed) {
    since_ += elapsed;
    const float fading = approach_ * static_cast<float>(std::exp(-elapsed / kLately));
    approach_ = std::max(fading, -glm::dot(velocity, metal.normal));
    const float off = metal.nearest - radius;
    if (touching_) {
        touching_ = off <= kLetGo;
    } else if (off <= 0) {
        touching_ = true;
        if (known_) {
            ++count_;
            since_ = 0;
            speed_ = approach_;
        }
    }
    known_ = true;
}

} // namespace meltpool
