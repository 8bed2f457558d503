// Meshes as PLY ("Polygon File Format", Turk 1994).
#pragma once

#include "app/export/coloured_mesh.hpp"

namespace meltpool {

/// Bytes of a PLY file, binary_little_endian 1.0: x, y, z in mm, as programs for printing and measuring read a file
/// without a unit, nx, ny, nz, and red, green, blue as displayed (sRGB, 8 bits).
std::string plyOf(const ColouredMesh& coloured);

} // namespace meltpool
