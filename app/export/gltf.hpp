// Meshes as glTF 2.0 (ISO/IEC 12113:2022).
#pragma once

#include "app/export/coloured_mesh.hpp"

namespace meltpool {

/// Contents of both formats: one mesh with POSITION in m and y upwards, as glTF demands, NORMAL, COLOR_0 in linear
/// colours of 16 bits, and indices of 32 bits, with a dull material that leaves the colours unchanged. Lesson, date,
/// program and axes are in asset.extras.

/// Bytes of a binary file, .glb.
std::string glbOf(const ColouredMesh& coloured);

/// Text of a .gltf file, with its numbers embedded (base64).
std::string gltfOf(const ColouredMesh& coloured);

} // namespace meltpool
