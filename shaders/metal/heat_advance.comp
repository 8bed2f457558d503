#version 450 core
// Adds the step's heat to each particle on the lattice: enthalpy with its residual, temperature, highest temperature, cooling
// time, phase. One group a tile of a list. MIXED: the particle has a share of its cell, and the cell's sums are cleared for
// the next step.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat_common.glsl"
#include "metal/heat_loose.glsl"
#include "metal/heat_update.glsl"
#include "metal/heat_loss.glsl"
#include "metal/heat_ledger.glsl"
#include "metal/heat_changes.glsl"
layout(std430, binding = HEAT_CELL_AREA) restrict readonly buffer CellArea { float cellArea[]; };
layout(std430, binding = HEAT_CELL_POWER) restrict readonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_LISTS) restrict readonly buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_HOMES) restrict writeonly buffer Homes { uint homes[]; };
#ifdef MIXED
layout(std430, binding = HEAT_CELL_SUMS) restrict buffer CellSums { HeatSum cellSums[]; };
#else
layout(std430, binding = HEAT_CELL_WEIGHT) restrict writeonly buffer CellWeights { float cellWeight[]; };
#endif
uniform int list;

#ifdef MIXED
/// What the particle itself takes up of its cell's heat, J.
float ownJoules(uint slot, int cell) {
    float weight = cellWeight[cell];
    float within = weight > 1.0 ? kWithin * metal.origin.w * (cellTheta[cell] - thermalState(heat[slot].x).y) : 0.0;
    float joules = (cellPower[cell] / weight + within) * heatBlock.time.x;
    float lost = particleLoss(slot, joules, cellArea[cell] / weight);
    book(cell, 0.0, lost);
    return joules - lost;
}
#else
float ownJoules(uint slot, int cell) {
    float joules = cellPower[cell] * heatBlock.time.x;
#ifdef EVAPORATION
    float hot = thermalState(heat[slot].x + joules / metal.gravity.w).x;
    float boiledOff = (hot - afterEvaporation(hot, cellArea[cell])) * heatBlock.evaporation.w * metal.gravity.w;
    book(cell, 0.0, boiledOff);
    joules -= boiledOff;
#endif
    return joules;
}
#endif

void main() {
    int tile = int(lists[list * heatBlock.step.w + int(gl_WorkGroupID.x)]);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    uint entry = lattice[cell];
    float theta = cellTheta[cell];
#ifdef MIXED
    cellSums[cell] = HeatSum(0u, 0u);
    if (entry == 0u) {
        cellTheta[cell] = kEmpty;
        cellWeight[cell] = 0.0;
    }
#endif
    if (entry == 0u || theta < 0.0) return;
    uint slot = entry - 1u;
    cellTheta[cell] = addHeat(slot, ownJoules(slot, cell), tiles[tile].since);
#ifdef MIXED
    cellWeight[cell] = 1.0;
#endif
    uint before = phase[slot];
    uint after = nextPhase(before, heat[slot].x);
    if (after == before) return;
    if ((after & PHASE_LIQUID) != 0u && heatBlock.step.z != 0) {
        after &= ~PHASE_LATTICE;
        lattice[cell] = 0u;
        cellTheta[cell] = kEmpty;
        cellWeight[cell] = 0.0;
        homes[slot] = 0u;
        tiles[tile].lastNeed = heatBlock.step.x;
    }
    phase[slot] = after;
    noteChange(slot);
}
