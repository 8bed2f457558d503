#version 450 core
// Adds the shares of each particle off the lattice to the weights, sums and ranges of the eight cells around it, and
// records their tiles.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/off_lattice.glsl"
#include "metal/heat/cell_range.glsl"
#include "metal/heat/metal_tiles.glsl"
layout(std430, binding = HEAT_CELL_SUMS) restrict buffer CellSums { uint cellSum[]; };

void noteOffLattice(int tile) {
    if (notesOf(tile).lastOffLattice == heatBlock.stepNumber) return;
    if (atomicExchange(tiles[tile].lastOffLattice, heatBlock.stepNumber) == TILE_UNLISTED) listMetalTile(tile);
}

void main() {
    uint entry = linearInvocation();
    if (entry >= control.offLatticeCount) return;
    uint slot = offLatticeSlot(entry);
    if ((texelFetch(phaseTexels, int(slot)).x & PHASE_ALIVE) == 0u) return;
    float theta = thermalState(texelFetch(heatTexels, int(slot)).x).y;
    Shares shares = sharesOf(texelFetch(positionTexels, int(slot)).xyz);
    for (int corner = 0; corner < 8; ++corner) {
        float weight;
        int cell = shareCell(shares, corner, weight);
        if (cell < 0 || weight == 0.0) continue;
        atomicAdd(cellWeight[cell], uint(weight * float(SHARE_UNIT)));
        atomicAdd(cellSum[cell], uint(weight * theta / heatBlock.thetaUnit + 0.5));
        addToRange(cell, theta);
        noteOffLattice(cell / TILE_CELLS);
    }
}
