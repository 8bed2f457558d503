#version 450 core
// Adds the step's heat to each particle on the lattice: enthalpy with its residual, temperature, highest temperature, cooling
// time, phase. One group a tile of the list.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat_common.glsl"
#include "metal/heat_update.glsl"
#include "metal/heat_loss.glsl"
#include "metal/heat_ledger.glsl"
#ifdef EVAPORATION
layout(std430, binding = HEAT_CELL_AREA) restrict readonly buffer CellArea { float cellArea[]; };
#endif
layout(std430, binding = HEAT_CELL_POWER) restrict readonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_TILE_LIST) restrict readonly buffer TileList { uint tileList[]; };

void main() {
    int tile = int(tileList[gl_WorkGroupID.x]);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    if (cellTheta[cell] < 0.0) return;
    uint slot = lattice[cell] - 1u;
    float joules = cellPower[cell] * heatBlock.time.x;
#ifdef EVAPORATION
    float hot = thermalState(heat[slot].x + joules / metal.gravity.w).x;
    float boiledOff = (hot - afterEvaporation(hot, cellArea[cell])) * heatBlock.evaporation.w * metal.gravity.w;
    book(slot, 0.0, boiledOff);
    joules -= boiledOff;
#endif
    cellTheta[cell] = addHeat(slot, joules, tiles[tile].since);
    uint before = phase[slot];
    uint after = nextPhase(before, heat[slot].x);
    if (after == before) return;
    bool leaves = (after & PHASE_LIQUID) != 0u && heatBlock.step.z != 0;
    if (leaves) {
        after &= ~PHASE_LATTICE;
        lattice[cell] = 0u;
        cellTheta[cell] = kEmpty;
        tiles[tile].lastNeed = heatBlock.step.x;
    }
    phase[slot] = after;
}
