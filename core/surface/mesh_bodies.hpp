// The bodies in a closed mesh: its connected parts, without the walls that are hidden inside them.
#pragma once

#include "core/surface/mesh_copy.hpp"

namespace meltpool {

/// Returns the connected parts of a closed mesh that are the outside of a body, the largest first; the rest is left
/// out. A part is the wall of a hollow when the volume that its triangles enclose (a sixth of the sum of a . (b x c))
/// is not positive, and is inside when a ray from it leaves a larger part more often than it enters it. Vertices that
/// no triangle uses any more are left out too. The parts keep the order of their vertices and triangles.
MeshCopy outerBodies(const MeshCopy& mesh);

/// Returns the number of connected parts of the mesh: parts that share no vertex.
size_t countParts(const MeshCopy& mesh);

} // namespace meltpool
