// Pose of the cut workpiece in the headset: flat on the table, the viewer would see the section from its edge.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace meltpool {

/// Section to look at, in the workpiece's frame, m.
struct CutFace {
    float at = 0;       ///< place of the cut along x
    glm::vec2 up{0, 1}; ///< direction in the section (z, y) that is to point up
    float extent = 0;   ///< size across all measures
    glm::vec3 low{0};   ///< corners of the box around the workpiece
    glm::vec3 high{0};
};

/// Returns `modelToRoom` turned about the middle of the cut so that the section faces a viewer who stands before the
/// table and looks down at it, enlarged so that the measures are at least 120 mm across, and lifted clear of the table.
/// `modelToRoom`: rotation, one scale and translation of the uncut workpiece. `table`: height of the table in the room,
/// m.
glm::mat4 standOfCut(const glm::mat4& modelToRoom, const CutFace& face, float table);

} // namespace meltpool
