#version 450 core
// Writes the Kirchhoff variable and the weight of every lattice cell from the particle that sits there, wakes every
// tile, and lists those with metal.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/metal_tiles.glsl"
layout(std430, binding = HEAT_KNOWN_CELLS) restrict writeonly buffer KnownCells { uint knownCell[]; };

void main() {
    uint cell = linearInvocation();
    uint cells = uint(heatBlock.tileCount) * TILE_CELLS;
    if (cell >= cells) return;
    uint entry = latticeSlot[cell];
    float theta = kEmpty;
    if (entry != 0u) {
        uint slot = entry - 1u;
        vec2 state = thermalState(heat[slot].x);
        theta = (phase[slot] & PHASE_HELD) != 0u ? markHeld(state.y) : state.y;
        position[slot].w = state.x;
        knownCell[slot] = cell + 1u;
    }
    cellTheta[cell] = theta;
    cellTheta[cells + cell] = theta;
    cellWeight[cell] = entry != 0u ? SHARE_UNIT : 0u;
    if (cell % TILE_CELLS != 0u) return;
    int now = heatBlock.stepNumber;
    int never = now - 1000;
    uint rows = 0u;
    for (uint inside = 0u; inside < TILE_CELLS; ++inside) rows |= uint(latticeSlot[cell + inside] != 0u) << inside / TILE_EDGE;
    int tile = int(cell / TILE_CELLS);
    bool hasMetal = rows != 0u;
    tiles[tile] = HeatTile(now, hasMetal ? never : TILE_UNLISTED, never, now, 0.0, heatBlock.endTime, rows, 0u);
    tileStamp[tile] = hasMetal ? now << TILE_STEP_SHIFT : TILE_NO_METAL;
    if (hasMetal) listMetalTile(tile);
}
