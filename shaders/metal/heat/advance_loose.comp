#version 450 core
// Gives each loose particle its share of what its cells took up, evens it out with them, and lets its free surface lose heat.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/loose.glsl"
#include "metal/heat/update.glsl"
#include "metal/heat/loss.glsl"
#include "metal/heat/ledger.glsl"
#include "metal/heat/leave.glsl"
layout(std430, binding = HEAT_CELL_POWER) restrict readonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_CELL_AREA) restrict readonly buffer CellArea { float cellArea[]; };

/// Watts that a particle that lies on the table gives to it. What is clamped or still on the lattice stands on its fixture.
float tableLoss(float height, float temperature) {
    float spacing = metal.spacing;
    if (height - heatBlock.loose.z > spacing) return 0.0;
    return heatBlock.loose.w * spacing * spacing * (temperature - heatBlock.time.z);
}

void main() {
    uint entry = linearInvocation();
    if (entry >= control.loose.w) return;
    uint slot = looseSlot(entry);
    uint before = texelFetch(phaseTexels, int(slot)).x;
    if ((before & PHASE_ALIVE) == 0u) return;
    vec4 h = texelFetch(heatTexels, int(slot));
    vec2 own = thermalState(h.x);
    vec3 place = texelFetch(positionTexels, int(slot)).xyz;
    Shares shares = sharesOf(place);
    float power = 0.0;
    float area = 0.0;
    float missing = 1.0;
    for (int corner = 0; corner < 8; ++corner) {
        float weight;
        int cell = shareCell(shares, corner, weight);
        if (cell < 0 || weight == 0.0) continue;
        float share = weight / texelFetch(weightTexels, cell).x;
        float mean = texelFetch(thetaTexels, thetaPlace(cell)).x;
        if (isHeld(mean)) continue;
        power += share * cellPower[cell] + weight * kWithin * metal.spacing * (mean - own.y);
        area += share * cellArea[cell];
        missing -= weight;
    }
    // Metal that left the lattice is all surface; 1e-3 leaves out what the whole-numbered weights lack.
    if (missing > 1e-3) area += 3.0 * missing * metal.spacing * metal.spacing;
    float joules = power * heatBlock.time.x;
    float lost = particleLoss(h.x, own.x, joules, area, heatBlock.time.x) + tableLoss(place.y, own.x) * heatBlock.time.x;
    book(heatBlock.step.w * TILE_CELLS + int(slot), 0.0, lost);
    Heated heated = addHeat(slot, h, own.x, joules - lost, heatBlock.time.x);
    uint after = nextPhase(before, heated.enthalpy);
    if (after == before) return;
    phase[slot] = after;
    noteChange(slot);
}
