#version 450 core
// Gives each loose particle its share of what its cells took up, evens it out with them, and lets its free surface lose heat.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#define MIXED
#include "metal/heat_common.glsl"
#include "metal/heat_loose.glsl"
#include "metal/heat_update.glsl"
#include "metal/heat_loss.glsl"
#include "metal/heat_ledger.glsl"
#include "metal/heat_changes.glsl"
layout(std430, binding = HEAT_CELL_POWER) restrict readonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_CELL_AREA) restrict readonly buffer CellArea { float cellArea[]; };
layout(std430, binding = HEAT_LISTS) restrict readonly buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_CONTROL) restrict readonly buffer Control { HeatControl control; };

/// Watts that a particle that lies on the table gives to it. What is clamped or still on the lattice stands on its fixture.
float tableLoss(uint slot) {
    float spacing = metal.origin.w;
    if (position[slot].y - heatBlock.loose.z > spacing) return 0.0;
    return heatBlock.loose.w * spacing * spacing * (position[slot].w - heatBlock.time.z);
}

void main() {
    uint entry = linearInvocation();
    if (entry >= control.loose.w) return;
    uint slot = lists[3 * heatBlock.step.w + entry];
    float theta = thermalState(heat[slot].x).y;
    Shares shares = sharesOf(position[slot].xyz);
    float power = 0.0;
    float area = 0.0;
    float missing = 1.0;
    for (int corner = 0; corner < 8; ++corner) {
        float weight;
        int cell = shareCell(shares, corner, weight);
        if (cell < 0 || weight == 0.0) continue;
        float share = weight / cellWeight[cell];
        float mean = cellTheta[cell];
        if (isHeld(mean)) continue;
        power += share * cellPower[cell] + weight * kWithin * metal.origin.w * (mean - theta);
        area += share * cellArea[cell];
        missing -= weight;
    }
    // Metal that left the lattice is all surface; 1e-3 leaves out what the whole-numbered weights lack.
    if (missing > 1e-3) area += 3.0 * missing * metal.origin.w * metal.origin.w;
    float lost = particleLoss(slot, power * heatBlock.time.x, area) + tableLoss(slot) * heatBlock.time.x;
    book(heatBlock.step.w * TILE_CELLS + int(slot), 0.0, lost);
    addHeat(slot, power * heatBlock.time.x - lost, heatBlock.time.x);
    uint before = phase[slot];
    uint after = nextPhase(before, heat[slot].x);
    if (after == before) return;
    phase[slot] = after;
    noteChange(slot);
}
