// The surface's mesh in the machine's own memory, for files and measures.
#pragma once

#include "core/surface/surface.hpp"

#include <cstdint>
#include <vector>

namespace meltpool {

/// Mesh with shared vertices: one for every edge of the grid that the surface cuts. A whole surface with caps is closed
/// by its indices, without comparing positions.
struct MeshCopy {
    std::vector<SurfaceVertex> vertices;
    /// a vertex's highest temperature so far; empty if the particles do not store it.
    std::vector<float> peaks;
    std::vector<std::uint32_t> indices; ///< three a triangle, counter-clockwise seen from outside
};

/// Copies the mesh of the last update, without its emptied triangles. Waits for the GPU. Throws RuntimeFault when the
/// mesh did not fit its buffers.
MeshCopy copyMesh(const Surface& surface);

} // namespace meltpool
