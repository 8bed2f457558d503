#version 450 core
// Gives the particles on the lattice of the mixed tiles their shares of what their cells took up, lets them lose heat, and
// clears the cells' sums for the next step. One group a tile.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat/common.glsl"
#include "metal/heat/loose.glsl"
#include "metal/heat/update.glsl"
#include "metal/heat/loss.glsl"
#include "metal/heat/ledger.glsl"
#include "metal/heat/leave.glsl"
layout(std430, binding = HEAT_CELL_AREA) restrict readonly buffer CellArea { float cellArea[]; };
layout(std430, binding = HEAT_CELL_POWER) restrict readonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_CELL_SUMS) restrict buffer CellSums { HeatSum cellSums[]; };

void main() {
    int tile = int(texelFetch(listTexels, heatBlock.step.w + int(gl_WorkGroupID.x)).x);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    int place = thetaBase(stampOf(tile), tile) + inside;
    uint entry = texelFetch(latticeTexels, cell).x;
    float mean = texelFetch(thetaTexels, place).x;
    cellSums[cell] = HeatSum(0u, 0u);
    if (entry == 0u) {
        cellTheta[place] = kEmpty;
        cellWeight[cell] = 0.0;
    }
    if (entry == 0u || mean < 0.0) return;
    uint slot = entry - 1u;
    vec4 h = texelFetch(heatTexels, int(slot));
    vec2 own = thermalState(h.x);
    float weight = texelFetch(weightTexels, cell).x;
    float within = weight > 1.0 ? kWithin * metal.spacing * (mean - own.y) : 0.0;
    float joules = (cellPower[cell] / weight + within) * heatBlock.time.x;
    float since = sinceOf(tile);
    float lost = particleLoss(h.x, own.x, joules, cellArea[cell] / weight, since);
    book(cell, 0.0, lost);
    Heated heated = addHeat(slot, h, own.x, joules - lost, since);
    cellTheta[place] = heated.theta;
    cellWeight[cell] = 1.0;
    writePhase(slot, cell, place, heated.enthalpy);
#ifdef EVAPORATION
    if (evaporates(heated.temperature)) tiles[tile].lastHot = heatBlock.step.x;
#endif
    if (lost != 0.0 && abs(own.x - heatBlock.time.z) > heatBlock.waking.y) tiles[tile].lastWarm = heatBlock.step.x;
}
