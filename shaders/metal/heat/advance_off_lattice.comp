#version 450 core
// Gives each particle off the lattice its share of its cells' heat, evens it out with them, and applies the loss of its
// free surface.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/off_lattice.glsl"
#include "metal/heat/cell_range.glsl"
#include "metal/heat/add_heat.glsl"
#include "metal/heat/surface_loss.glsl"
#include "metal/heat/ledger.glsl"
#include "metal/heat/leave_lattice.glsl"
layout(std430, binding = HEAT_CELL_POWER) restrict readonly buffer CellPower { float cellPower[]; };

/// Watts from a particle to the welding table that it rests on. Metal that is clamped or still on the lattice rests on
/// its fixture and does not touch the table.
float tableLoss(vec3 place, float temperature) {
    float spacing = metal.spacing;
    float height = dot(place, heatBlock.weldingTableNormal);
    if (height - heatBlock.weldingTableHeight > spacing) return 0.0;
    return heatBlock.weldingTableConductance * spacing * spacing * (temperature - heatBlock.ambient);
}

void main() {
    uint entry = linearInvocation();
    if (entry >= control.offLatticeCount) return;
    uint slot = offLatticeSlot(entry);
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
        float share = weight / weightOf(cell);
        int tile = cell / TILE_CELLS;
        int stamp = stampOf(tile);
        int inside = cell - tile * TILE_CELLS;
        float mean = texelFetch(thetaTexels, thetaBase(stamp, tile) + inside).x;
        if (isHeld(mean)) continue;
        power += share * (cellPower[cell] + exchangeOf(cell) * metal.spacing * (mean - own.y));
        area += share * texelFetch(thetaTexels, thetaBase(stamp ^ TILE_HALF, tile) + inside).x;
        missing -= weight;
    }
    // The share of a particle outside the lattice is all surface; 1e-3 ignores the rounding of the integer weights.
    if (missing > 1e-3) area += 3.0 * missing * metal.spacing * metal.spacing;
    float joules = power * heatBlock.timeStep;
    float lost =
        particleLoss(h.x, own.x, joules, area, heatBlock.timeStep) + tableLoss(place, own.x) * heatBlock.timeStep;
    book(heatBlock.tileCount * TILE_CELLS + int(slot), 0.0, lost);
    Heated heated = addHeat(slot, h, own.x, joules - lost, heatBlock.timeStep);
    uint after = nextPhase(before, heated.enthalpy);
    if (after == before) return;
    phase[slot] = after;
    noteChange(slot, after);
}
