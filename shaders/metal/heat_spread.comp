#version 450 core
// A whole step of the plain tiles, where metal on the lattice conducts and its surface loses heat to the air, and nothing
// else happens: theta in one half of its buffer -> enthalpy, temperature, phase, theta in the other half. One group a tile.
// What no branch can hide (drivers that run on the CPU pay for every line whether its condition holds or not) is left to
// the passes over mixed tiles.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat_common.glsl"
#include "metal/heat_update.glsl"
#include "metal/heat_loss.glsl"
#include "metal/heat_ledger.glsl"
#include "metal/heat_leave.glsl"

void main() {
    int tile = int(texelFetch(listTexels, int(gl_WorkGroupID.x)).x);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    int stamp = stampOf(tile);
    int place = thetaBase(stamp, tile) + inside;
    int otherHalf = thetaBase(stamp ^ TILE_HALF, tile) + inside;
    float theta = texelFetch(thetaTexels, place).x;
    if (theta < 0.0) {
        cellTheta[otherHalf] = theta;
        return;
    }
    Neighbours n = readNeighbours(tile, stamp, inside, cellsBeside(tileCoordinate(tile), inside));
    Inflow inflow = inflowOf(n, theta);
    vec2 power = powerOf(inflow, n);
    uint slot = texelFetch(latticeTexels, cell).x - 1u;
    vec4 h = texelFetch(heatTexels, int(slot));
    float temperature = thermalState(h.x).x;
    float since = sinceOf(tile);
    float losing = surfaceLoss(temperature, freeArea(n));
    float lost = losing * since; // may be due for several steps at once

    ivec4 notes = notesOf(tile);
    if (keepsAwake(inflow) || abs(losing) * heatBlock.time.x > heatBlock.waking.z) noteNeed(tile, notes);
    if (losing != 0.0 && abs(temperature - heatBlock.time.z) > heatBlock.waking.y &&
        heatBlock.step.x - notes.z >= TILE_NOTE)
        tiles[tile].lastWarm = heatBlock.step.x;
    book(cell, power.y * heatBlock.time.x, lost);

    Heated heated = addHeat(slot, h, temperature, (power.x + power.y) * heatBlock.time.x - lost, since);
    cellTheta[otherHalf] = heated.theta;
    writePhase(slot, cell, otherHalf, heated.enthalpy);
#ifdef EVAPORATION
    if (evaporates(heated.temperature) && heatBlock.step.x - notes.w >= TILE_NOTE)
        tiles[tile].lastHot = heatBlock.step.x;
#endif
}
