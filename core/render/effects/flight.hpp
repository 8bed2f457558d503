// The flight of a free drop, in closed form from its birth, and its landing place.
#pragma once

#include "core/weld/workpiece/workpiece.hpp"

#include <optional>
#include <span>

namespace meltpool {

/// Faces on which spatter lands, in the workpiece's frame, m.
struct SpatterGround {
    std::span<const WorkpieceBlock> blocks; ///< must outlive every object that stores this
    glm::vec3 up{0, 1, 0};                  ///< unit vector against gravity
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
    glm::vec3 normal{0}; ///< unit normal of the face
    bool onTable = false;
};

/// Returns the first face of the workpiece's blocks that the flight enters, or the table; nothing if it meets neither.
std::optional<Landing> landingOf(const Flight& flight, const SpatterGround& ground);

} // namespace meltpool
