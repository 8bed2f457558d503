#version 450 core
// Writes the Kirchhoff variable and the weight of every lattice cell from the particle that sits there, and wakes every tile.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat_common.glsl"
layout(std430, binding = HEAT_CELL_WEIGHT) restrict writeonly buffer CellWeights { float cellWeight[]; };
layout(std430, binding = HEAT_HOMES) restrict writeonly buffer Homes { uint homes[]; };

void main() {
    uint cell = linearInvocation();
    if (cell >= uint(heatBlock.step.w) * TILE_CELLS) return;
    uint entry = lattice[cell];
    float theta = kEmpty;
    if (entry != 0u) {
        uint slot = entry - 1u;
        vec2 state = thermalState(heat[slot].x);
        theta = (phase[slot] & PHASE_HELD) != 0u ? markHeld(state.y) : state.y;
        position[slot].w = state.x;
        homes[slot] = cell + 1u;
    }
    cellTheta[cell] = theta;
    cellWeight[cell] = entry != 0u ? 1.0 : 0.0;
    if (cell % TILE_CELLS != 0u) return;
    tiles[cell / TILE_CELLS] = HeatTile(heatBlock.step.x, -2, 0.0, -2);
    bool filled = false;
    for (uint inside = 0u; inside < TILE_CELLS; ++inside) filled = filled || lattice[cell + inside] != 0u;
    tileStamp[cell / TILE_CELLS] = filled ? -1 : TILE_NO_METAL;
}
