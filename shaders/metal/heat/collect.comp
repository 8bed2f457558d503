#version 450 core
// Lists living particles off the lattice that are not in the list yet, among a range of slots. One that left without heat's
// doing gives its cell back here.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/update.glsl"
#include "metal/heat/leave.glsl"
uniform uint first;
uniform uint last;

void main() {
    uint slot = first + linearInvocation();
    if (slot >= last) return;
    uint bits = texelFetch(phaseTexels, int(slot)).x;
    if ((bits & (PHASE_ALIVE | PHASE_LATTICE)) == (PHASE_ALIVE | PHASE_LATTICE)) return;
    uint home = homes[slot];
    if (home == HEAT_LOOSE) return;
    homes[slot] = 0u;
    if (home != 0u) {
        int cell = int(home) - 1;
        freeCell(cell, cell);
        freeCell(cell, heatBlock.step.w * TILE_CELLS + cell);
    }
    // What is held off the lattice is a wall that no heat crosses.
    if ((bits & (PHASE_ALIVE | PHASE_HELD)) == PHASE_ALIVE) joinLoose(slot);
}
