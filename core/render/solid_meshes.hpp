// The triangles of every shape of solid.
#pragma once

#include "core/render/solid.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace meltpool {

struct SolidVertex {
    glm::vec3 position;
    glm::vec3 normal; ///< unit
};

/// All shapes in one list of vertices and one of indices.
struct SolidMeshes {
    /// Range of the indices; they count from the first vertex of the whole list.
    struct Range {
        int first = 0;
        int count = 0;
    };

    std::vector<SolidVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::array<Range, kSolidShapes> shapes; ///< ranges in the order of SolidShape
};

/// Front faces are counterclockwise. Round shapes have 32 sides, the pill 20.
SolidMeshes makeSolidMeshes();

} // namespace meltpool
