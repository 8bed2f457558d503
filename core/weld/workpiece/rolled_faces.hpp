// Which faces of a workpiece are as the mill rolled them, and where they were ground before welding.
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

/// Where mill scale covers a workpiece of hot-rolled steel.
struct RolledFaces {
    static constexpr size_t kMost = 3;
    std::array<RolledPart, kMost> parts;
    size_t count = 0;       ///< 0: nothing is rolled
    glm::vec3 across{0};    ///< 1 for each axis across the seam, else 0: a place's distance is that of what these leave
    float ground = kGround; ///< m from the seam up to which the faces are ground bright
    /// Welders grind a band of some 20 mm along a seam: half of that to either side. Trade knowledge.
    static constexpr float kGround = 0.010F;
};

/// Plates and pipes are rolled: a plate's large faces up to its bevel, a pipe's outer and inner one. Cubes and bridges
/// are cast.
RolledFaces rolledFaces(const WorkpieceParameters& parameters, const Workpiece& workpiece);

} // namespace meltpool
