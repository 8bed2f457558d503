// Uniform block of the step and geometry of the grid, for all passes of the classic model.
#include "shared/classic.h"
#include "shared/dispatch.h"

layout(std140, binding = CLASSIC_STEP) uniform StepBlock { ClassicStep now; };

/// The cell of a position along each axis; positions on the far wall belong to the last cell.
ivec3 cellOf(vec3 place) {
    return clamp(ivec3((place + 1.0) * now.cellsPerUnit), ivec3(0), ivec3(int(now.cellsPerAxis) - 1));
}

/// Cells are stored x fastest, then y, then z: neighbours along x are neighbours in memory.
uint cellIndex(ivec3 cell) {
    return uint((cell.z * int(now.cellsPerAxis) + cell.y) * int(now.cellsPerAxis) + cell.x);
}
