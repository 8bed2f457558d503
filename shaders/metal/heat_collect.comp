#version 450 core
// Lists the living particles that are off the lattice. One that left without heat's doing gives its cell back here.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat_common.glsl"
layout(std430, binding = HEAT_CELL_WEIGHT) restrict buffer CellWeights { float cellWeight[]; };
layout(std430, binding = HEAT_LISTS) restrict writeonly buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_CONTROL) restrict buffer Control { HeatControl control; };
layout(std430, binding = HEAT_HOMES) restrict buffer Homes { uint homes[]; };

void main() {
    uint slot = linearInvocation();
    if (slot >= uint(heatBlock.loose.y)) return;
    uint bits = phase[slot];
    if ((bits & (PHASE_ALIVE | PHASE_LATTICE)) == (PHASE_ALIVE | PHASE_LATTICE)) return;
    uint home = homes[slot];
    if (home != 0u) {
        homes[slot] = 0u;
        cellTheta[home - 1u] = kEmpty;
        cellWeight[home - 1u] = 0.0;
        tiles[(home - 1u) / TILE_CELLS].lastNeed = heatBlock.step.x;
    }
    // What is held off the lattice is a wall that no heat crosses.
    if ((bits & (PHASE_ALIVE | PHASE_HELD)) != PHASE_ALIVE) return;
    uint place = atomicAdd(control.loose.w, 1u);
    if (place % GROUP_SIZE == 0u) atomicAdd(control.loose.x, 1u);
    lists[3 * heatBlock.step.w + place] = slot;
}
