#version 450 core
// Net power into each cell: conduction with its six neighbours through the Kirchhoff variable, less what the free surface
// loses. One group a tile of a list. Sources are added by a pass of their own: drivers that run on the CPU pay for every line
// whether its condition holds or not.
//
// Two cells exchange dx (theta_j - theta_i): k A/dx with k inside theta. A held neighbour stands for a wall at the face
// between the two, half as far away. A face is counted when both its tiles take part, so what one side gives the other gets.
// MIXED: loose metal shares cells here. A face then conducts as the lesser filled of its cells allows, and what the surface
// loses is left to the particles.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat_common.glsl"
#include "metal/heat_loss.glsl"
#include "metal/heat_ledger.glsl"
layout(std430, binding = HEAT_CELL_AREA) restrict writeonly buffer CellArea { float cellArea[]; };
layout(std430, binding = HEAT_CELL_POWER) restrict writeonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_LISTS) restrict readonly buffer Lists { uint lists[]; };
uniform int list;

void main() {
    int tile = int(lists[list * heatBlock.step.w + int(gl_WorkGroupID.x)]);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    float theta = cellTheta[cell];
    if (theta < 0.0) return;
    float spacing = metal.origin.w;
    ivec3 tilePlace = tileCoordinate(tile);
    Neighbours n = readNeighbours(tile, tilePlace, inside, heatBlock.step.x);

    // Where nothing sits the difference is 0; a wall's heat comes from outside the metal, so it needs no open partner.
    bvec3 wallLow = lessThan(n.low, vec3(-1.5));
    bvec3 wallHigh = lessThan(n.high, vec3(-1.5));
    vec3 flowLow = mix(n.low - theta, 2.0 * (-2.0 - n.low - theta), wallLow) * (1.0 - emptyMask(n.low));
    vec3 flowHigh = mix(n.high - theta, 2.0 * (-2.0 - n.high - theta), wallHigh) * (1.0 - emptyMask(n.high));
    vec3 largest = max(abs(flowLow), abs(flowHigh));
    bool need = max(max(largest.x, largest.y), largest.z) > heatBlock.waking.x;
#ifdef MIXED
    float weight = cellWeight[cell];
    vec3 weightLow, weightHigh;
    readWeights(tile, tilePlace, inside, weightLow, weightHigh);
    flowLow *= min(vec3(1), min(vec3(weight), weightLow));
    flowHigh *= min(vec3(1), min(vec3(weight), weightHigh));
#endif
    vec3 fromWalls = flowLow * vec3(wallLow) + flowHigh * vec3(wallHigh);
    vec3 fromMetal = flowLow * vec3(n.openLow) * vec3(not(wallLow)) + flowHigh * vec3(n.openHigh) * vec3(not(wallHigh));
    float gained = spacing * (fromWalls.x + fromWalls.y + fromWalls.z);
    float power = spacing * (fromMetal.x + fromMetal.y + fromMetal.z) + gained;

    float lost = 0.0;
#ifdef MIXED
    cellArea[cell] = freeSurface(weight, weightLow, weightHigh).w;
#else
    vec4 surface = freeSurface(n);
    float temperature = position[lattice[cell] - 1u].w;
    float losing = surfaceLoss(temperature, surface.w);
    // Surface loss may be due for several steps at once.
    lost = losing * tiles[tile].since / heatBlock.time.x;
    need = need || abs(losing) * heatBlock.time.x > heatBlock.waking.z;
    if (surface.w > 0.0 && abs(temperature - heatBlock.time.z) > heatBlock.waking.y && heatBlock.time.y > 0.0)
        tiles[tile].lastWarm = heatBlock.step.x;
#ifdef EVAPORATION
    cellArea[cell] = surface.w;
#endif
#endif
    if (need && tiles[tile].lastNeed != heatBlock.step.x) tiles[tile].lastNeed = heatBlock.step.x;
    cellPower[cell] = power - lost;
    book(cell, gained * heatBlock.time.x, lost * heatBlock.time.x);
}
