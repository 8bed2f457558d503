#version 450 core
// Gives the particles on the lattice of the mixed tiles their shares of their cells' heat, applies the surface loss,
// and clears the cells' sums for the next step. An invocation a cell.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/cell_range.glsl"
#include "metal/heat/add_heat.glsl"
#include "metal/heat/surface_loss.glsl"
#include "metal/heat/ledger.glsl"
#include "metal/heat/leave_lattice.glsl"
#include "metal/heat/listed_rows.glsl"
layout(std430, binding = HEAT_CELL_POWER) restrict buffer CellPower { float cellPower[]; };

void main() {
    bool reached = gl_WorkGroupID.x < control.reachedRows.x;
    uint group = gl_WorkGroupID.x - (reached ? 0u : control.reachedRows.x);
    uint listed = (group * GROUP_SIZE + gl_LocalInvocationIndex) / TILE_EDGE;
    if (listed >= (reached ? control.reachedRows.w : control.unreachedRows.w)) return;
    int row = listedRow(placeOfMixed(reached, listed));
    int cell = TILE_EDGE * row + int(gl_LocalInvocationIndex % TILE_EDGE);
    int tile = cell / TILE_CELLS;
    int inside = cell % TILE_CELLS;
    int stamp = stampOf(tile);
    int index = thetaBase(stamp, tile) + inside;
    int otherHalf = thetaBase(stamp ^ TILE_HALF, tile) + inside;
    uint entry = texelFetch(latticeTexels, cell).x;
    float mean = texelFetch(thetaTexels, index).x;
    float power = cellPower[cell];
    cellPower[cell] = 0.0; // the bits of 0.0 as an integer are an empty sum
    if (entry == 0u) cellTheta[index] = cellTheta[otherHalf] = kEmpty;
    float weight = weightOf(cell);
    bool sharesCell = isShared(cell);
    float exchange = exchangeOf(cell);
    if (sharesCell) clearRange(cell);
    cellWeight[cell] = entry == 0u ? 0u : SHARE_UNIT;
    if (entry == 0u || mean < 0.0) return;
    uint slot = entry - 1u;
    float area = texelFetch(thetaTexels, otherHalf).x;
    vec4 h = texelFetch(heatTexels, int(slot));
    vec2 own = thermalState(h.x);
    float exchanged = sharesCell ? exchange * metal.spacing * (mean - own.y) : 0.0;
    float joules = (power + exchanged) / weight * heatBlock.timeStep;
    float elapsed = elapsedOf(tile);
    float lost = particleLoss(h.x, own.x, joules, area / weight, elapsed);
    book(cell, 0.0, lost);
    Heated heated = addHeat(slot, h, own.x, joules - lost, elapsed);
    cellTheta[index] = heated.theta;
    writePhase(slot, cell, index, heated.enthalpy);
#ifdef EVAPORATION
    if (evaporates(heated.temperature)) tiles[tile].lastEvaporating = heatBlock.stepNumber;
#endif
    bool warm = lost != 0.0 && abs(own.x - heatBlock.ambient) > heatBlock.warmAboveAmbient;
    if (warm) tiles[tile].lastWarm = heatBlock.stepNumber;
}
