// A gloved hand round a handle or a rod, of a few round solids.
#pragma once

#include "core/render/solid.hpp"

#include <vector>

namespace meltpool {

/// Grip of a hand round a handle or rod; unit vectors, m.
struct HandGrip {
    glm::vec3 middle{0.0f};   ///< on the axis of the handle
    glm::vec3 along{0, 0, 1}; ///< direction along that axis, away from the work
    glm::vec3 palm{0, 1, 0};  ///< direction from the axis to the back of the hand, at right angles to `along`
    glm::vec3 arm{0, 0, 1};   ///< direction from the wrist to the elbow
    float radius = 0.013f;    ///< radius of the handle
};

/// Adds palm, fingers, thumb and cuff of a welding glove. `toWorld`: of the grip's frame.
void addGlovedHand(std::vector<Solid>& solids, const HandGrip& grip, const glm::mat4& toWorld);

} // namespace meltpool
