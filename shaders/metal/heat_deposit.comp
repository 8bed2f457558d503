#version 450 core
// Adds each loose particle's share to the sums of the eight cells around it.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat_common.glsl"
#include "metal/heat_loose.glsl"
layout(std430, binding = HEAT_CELL_SUMS) restrict buffer CellSums { HeatSum cellSums[]; };
layout(std430, binding = HEAT_LISTS) restrict readonly buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_CONTROL) restrict readonly buffer Control { HeatControl control; };

void main() {
    uint entry = linearInvocation();
    if (entry >= control.loose.w) return;
    uint slot = lists[3 * heatBlock.step.w + entry];
    vec2 state = thermalState(heat[slot].x);
    position[slot].w = state.x;
    Shares shares = sharesOf(position[slot].xyz);
    for (int corner = 0; corner < 8; ++corner) {
        float weight;
        int cell = shareCell(shares, corner, weight);
        if (cell < 0 || weight == 0.0) continue;
        atomicAdd(cellSums[cell].weight, uint(weight * LOOSE_UNIT));
        atomicAdd(cellSums[cell].theta, uint(weight * state.y / heatBlock.loose.x + 0.5));
        tiles[cell / TILE_CELLS].lastLoose = heatBlock.step.x;
    }
}
