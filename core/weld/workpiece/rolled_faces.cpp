#include "core/weld/workpiece/rolled_faces.hpp"

#include <algorithm>

namespace meltpool {

namespace {

/// Returns a plate, which is rolled on the faces across its thickness.
RolledPart plate(const glm::vec3& low, const glm::vec3& high) {
    const glm::vec3 size = high - low;
    const float thickness = std::min({size.x, size.y, size.z});
    RolledPart part{low, high, glm::vec3(0)};
    for (int axis = 0; axis < 3; ++axis)
        if (size[axis] == thickness) {
            part.faces[axis] = 1;
            return part;
        }
    return part;
}

} // namespace

RolledFaces rolledFaces(const WorkpieceParameters& parameters, const Workpiece& workpiece) {
    RolledFaces rolled;
    const auto kind = static_cast<WorkpieceKind>(parameters.kind);
    if (kind == WorkpieceKind::Cube || kind == WorkpieceKind::Bridge) return rolled;
    if (kind == WorkpieceKind::Pipe) { // the axis of a pipe is z, and its seam runs around it
        rolled.across = {0, 0, 1};
        rolled.parts[rolled.count++] = {workpiece.bodyLow, workpiece.bodyHigh, {1, 1, 0}};
        return rolled;
    }
    rolled.across = {0, 1, 1};
    for (const WorkpieceBlock& block : workpiece.blocks)
        if (rolled.count < RolledFaces::kMost) rolled.parts[rolled.count++] = plate(block.low, block.high);
    return rolled;
}

} // namespace meltpool
