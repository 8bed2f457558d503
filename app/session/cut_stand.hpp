// How the headset holds the cut workpiece: as it lies, a person before it sees the section from its edge.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace meltpool {

/// The section that is to be looked at, in the workpiece's frame, m.
struct CutFace {
    float at = 0;       ///< of the cut, along x
    glm::vec2 up{0, 1}; ///< of the section (z, y): what is to be up
    float extent = 0;   ///< across its measures
    glm::vec3 low{0};   ///< corners of the box around the workpiece
    glm::vec3 high{0};
};

/// Turns the workpiece about the middle of the cut so that the section faces somebody who stands before the table and
/// looks down at it, enlarged so that the measures are at least 120 mm across, and lifts it clear of the table.
/// `modelToRoom`: as it lies; rotation, one scale, translation. `table`: height of the table in the room, m.
glm::mat4 standOfCut(const glm::mat4& modelToRoom, const CutFace& face, float table);

} // namespace meltpool
