#version 450 core
// Writes the Kirchhoff variable of every lattice cell from the particle that sits there, and wakes every tile.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat_common.glsl"

void main() {
    uint cell = linearInvocation();
    if (cell >= uint(heatBlock.step.w) * TILE_CELLS) return;
    uint slot = lattice[cell];
    float theta = kEmpty;
    if (slot != 0u) {
        vec2 state = thermalState(heat[slot - 1u].x);
        theta = (phase[slot - 1u] & PHASE_HELD) != 0u ? markHeld(state.y) : state.y;
        position[slot - 1u].w = state.x;
    }
    cellTheta[cell] = theta;
    if (cell % TILE_CELLS != 0u) return;
    tiles[cell / TILE_CELLS] = HeatTile(heatBlock.step.x, -2, 0.0, 0);
    tileStamp[cell / TILE_CELLS] = -1;
}
