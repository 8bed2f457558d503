#version 450 core
// Lists living particles off the lattice that are not in the list yet, among a range of slots. Empties the cells of
// those that other passes took off the lattice.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/add_heat.glsl"
#include "metal/heat/leave_lattice.glsl"
uniform uint first;
uniform uint last;

void main() {
    uint slot = first + linearInvocation();
    if (slot >= last) return;
    uint bits = texelFetch(phaseTexels, int(slot)).x;
    if ((bits & (PHASE_ALIVE | PHASE_LATTICE)) == (PHASE_ALIVE | PHASE_LATTICE)) return;
    uint known = knownCell[slot];
    if (known == HEAT_OFF_LATTICE) return;
    knownCell[slot] = 0u;
    if (known != 0u) {
        int cell = int(known) - 1;
        emptyCell(cell, cell);
        emptyCell(cell, heatBlock.tileCount * TILE_CELLS + cell);
    }
    // A held particle off the lattice is a wall that no heat crosses.
    if ((bits & (PHASE_ALIVE | PHASE_HELD)) == PHASE_ALIVE) listOffLattice(slot);
}
