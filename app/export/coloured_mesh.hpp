// A mesh for the writers of files.
#pragma once

#include "core/surface/mesh_copy.hpp"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace meltpool {

/// Notes in a file about itself.
struct MeshNotes {
    std::string lesson;
    std::string date;    ///< UTC, such as 2026-03-01T12:00:00Z
    std::string program; ///< version and commit
};

struct ColouredMesh {
    MeshCopy mesh;                  ///< m, y upwards; at least one triangle
    std::vector<glm::vec3> colours; ///< linear sRGB 0..1, one per vertex
    MeshNotes notes;
};

/// Note in every file about the axes.
inline constexpr const char* kMeshAxes = "y points upwards; of a workpiece that lies flat, x runs along the seam";

} // namespace meltpool
