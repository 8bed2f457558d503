// Soapstone marks beside a joint, at either end of the length to weld: where it counts from and to, with an arrow in
// the direction of travel at the first. They are on the piece, as a welder draws them, and no cue.
#pragma once

#include "core/render/solid.hpp"
#include "core/weld/workpiece/workpiece.hpp"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace meltpool {

/// An end of that length, workpiece frame.
struct JointEnd {
    glm::vec3 point{0};        ///< m, on the line to weld
    glm::vec3 across{0, 0, 1}; ///< unit vector across the line
    glm::vec3 up{0, 1, 0};     ///< unit vector out of the joint
    glm::vec3 along{1, 0, 0};  ///< unit vector along the line, in the direction of travel
};

/// Returns strokes on the faces at both sides of each end, farther from the line than a weld is wide, and an arrow at
/// the first end, on the side that `across` points to if it has a face; none where there is no face. `blocks`: the
/// workpiece; without any its face runs straight across, as along a pipe's axis.
std::vector<Solid> jointMarks(std::span<const JointEnd> ends, std::span<const WorkpieceBlock> blocks);

} // namespace meltpool
