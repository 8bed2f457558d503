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
    bool mirrored = false;    ///< the fingers close the other way round
};

/// A hand of which the headset knows place and directions; unit vectors, m.
struct TrackedHand {
    glm::vec3 place{0.0f};      ///< middle of the closed hand
    glm::vec3 back{-1, 0, 0};   ///< out of the back of the hand
    glm::vec3 forearm{0, 0, 1}; ///< from the wrist to the elbow
    bool right = false;
};

/// Returns the grip of that hand round a handle that leads along `way` away from the work at `tip` (m). The drawn
/// forearm comes no nearer to the tip than the hand, so that it does not cover the work.
HandGrip gripOf(const TrackedHand& hand, const glm::vec3& way, const glm::vec3& tip, float radius);

/// Returns the grip of that hand with a thin rod between thumb and fingers; `way` leads away from the rod's end.
HandGrip rodGripOf(const TrackedHand& hand, const glm::vec3& way, const glm::vec3& rodTip);

/// Adds palm, fingers, thumb and cuff of a welding glove. `toWorld`: of the grip's frame.
void addGlovedHand(std::vector<Solid>& solids, const HandGrip& grip, const glm::mat4& toWorld);

} // namespace meltpool
