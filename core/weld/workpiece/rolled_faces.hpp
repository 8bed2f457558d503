// Rolled faces of a workpiece with their mill scale, and the band that is ground before welding.
#pragma once

#include "core/weld/workpiece/workpiece.hpp"

#include <array>

namespace meltpool {

/// A plate or pipe. Its other faces are sheared or machined, and bright.
struct RolledPart {
    glm::vec3 low{0};   ///< m, box around it
    glm::vec3 high{0};  ///< m
    glm::vec3 faces{0}; ///< 1 for each axis that its rolled faces look along, else 0
};

/// Areas of mill scale on a workpiece of hot-rolled steel.
struct RolledFaces {
    static constexpr size_t kMost = 3;
    std::array<RolledPart, kMost> parts;
    size_t count = 0; ///< 0: nothing is rolled
    /// 1 for each axis across the seam, else 0: masks the components that count for a place's distance.
    glm::vec3 across{0};
    float ground = kGround; ///< m from the seam up to which the faces are ground bright
    /// Half of the band of some 20 mm that welders grind along a seam, to either side. Trade knowledge.
    static constexpr float kGround = 0.010F;
};

/// Returns the rolled faces. Plates and pipes are rolled: a plate's large faces up to its bevel, a pipe's outer and
/// inner one. Cubes and bridges are cast.
RolledFaces rolledFaces(const WorkpieceParameters& parameters, const Workpiece& workpiece);

} // namespace meltpool
