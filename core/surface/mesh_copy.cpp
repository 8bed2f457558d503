#include "core/surface/mesh_copy.hpp"

#include "core/base/error.hpp"

namespace meltpool {

MeshCopy copyMesh(const Surface& surface) {
    const SurfaceStatistics size = surface.statistics();
    if (size.overflow) throw RuntimeFault("the metal's surface is too large for its mesh; use a coarser grid");
    const SurfaceMesh mesh = surface.mesh();
    MeshCopy copy;
    copy.vertices = mesh.vertices->read<SurfaceVertex>(size.vertices);
    if (mesh.peaks != nullptr) copy.peaks = mesh.peaks->read<float>(size.vertices);
    const auto indices = mesh.indices->read<std::uint32_t>(size_t(size.triangles) * 3);
    copy.indices.reserve(indices.size());
    for (size_t i = 0; i < indices.size(); i += 3)
        if (indices[i] != indices[i + 1]) copy.indices.insert(copy.indices.end(), &indices[i], &indices[i] + 3);
    return copy;
}

} // namespace meltpool
