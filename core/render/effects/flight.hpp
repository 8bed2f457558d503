// The way of a drop that flies free, in closed form from its birth, and where it lands.
#pragma once

#include "core/weld/workpiece/workpiece.hpp"

#include <optional>
#include <span>

namespace meltpool {

/// What spatter lands on, in the workpiece's frame, m.
struct SpatterGround {
    std::span<const WorkpieceBlock> blocks; ///< must outlive whoever keeps this
    glm::vec3 up{0, 1, 0};                  ///< unit, against gravity
    float table = -1;                       ///< height of the table along `up`
};

/// A throw without drag: half a millimetre of steel loses a tenth of its speed in the time that it is seen.
struct Flight {
    glm::vec3 from{0};     ///< m
    glm::vec3 velocity{0}; ///< m/s at birth
    glm::vec3 gravity{0, -9.81F, 0};

    glm::vec3 at(float age) const { return from + (velocity + 0.5F * age * gravity) * age; }
    glm::vec3 velocityAt(float age) const { return velocity + gravity * age; }
};

struct Landing {
    float age = 0;       ///< s from birth
    glm::vec3 normal{0}; ///< unit, of the face
    bool onTable = false;
};

/// The first face of the workpiece's blocks that the flight enters, or the table; nothing where it meets neither.
std::optional<Landing> landingOf(const Flight& flight, const SpatterGround& ground);

} // namespace meltpool
