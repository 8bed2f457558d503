#version 450 core
// Net power into each particle on the lattice: conduction with its six neighbours through the Kirchhoff variable less what
// the free surface loses. One group a tile of the list. Sources are added by a pass of their own: drivers that run on the
// CPU pay for every line whether its condition holds or not.
//
// Two cells exchange dx (theta_j - theta_i): k A/dx with k inside theta. A held neighbour stands for a wall at the face
// between the two, half as far away. A face is counted when both its tiles take part, so what one side gives the other gets.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat_common.glsl"
#include "metal/heat_loss.glsl"
layout(std430, binding = HEAT_CELL_POWER) restrict writeonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_TILE_LIST) restrict readonly buffer TileList { uint tileList[]; };
#include "metal/heat_ledger.glsl"
#ifdef EVAPORATION
layout(std430, binding = HEAT_CELL_AREA) restrict writeonly buffer CellArea { float cellArea[]; };
#endif

void main() {
    int tile = int(tileList[gl_WorkGroupID.x]);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    float theta = cellTheta[cell];
    if (theta < 0.0) return;
    uint slot = lattice[cell] - 1u;
    float spacing = metal.origin.w;
    float temperature = position[slot].w;
    ivec3 tilePlace = tileCoordinate(tile);
    Neighbours n = readNeighbours(tile, tilePlace, inside, heatBlock.step.x);

    // Where nothing sits the difference is 0; a wall's heat comes from outside the metal, so it needs no open partner.
    bvec3 wallLow = lessThan(n.low, vec3(-1.5));
    bvec3 wallHigh = lessThan(n.high, vec3(-1.5));
    vec3 flowLow = mix(n.low - theta, 2.0 * (-2.0 - n.low - theta), wallLow) * (1.0 - emptyMask(n.low));
    vec3 flowHigh = mix(n.high - theta, 2.0 * (-2.0 - n.high - theta), wallHigh) * (1.0 - emptyMask(n.high));
    vec3 largest = max(abs(flowLow), abs(flowHigh));
    bool need = max(max(largest.x, largest.y), largest.z) > heatBlock.waking.x;
    vec3 fromWalls = flowLow * vec3(wallLow) + flowHigh * vec3(wallHigh);
    vec3 fromMetal = flowLow * vec3(n.openLow) * vec3(not(wallLow)) + flowHigh * vec3(n.openHigh) * vec3(not(wallHigh));
    float gained = spacing * (fromWalls.x + fromWalls.y + fromWalls.z);
    float power = spacing * (fromMetal.x + fromMetal.y + fromMetal.z) + gained;

    vec4 surface = freeSurface(n);
    // Surface loss may be due for several steps at once.
    float losing = surfaceLoss(temperature, surface.w);
    float lost = losing * tiles[tile].since / heatBlock.time.x;
    need = need || abs(losing) * heatBlock.time.x > heatBlock.waking.z;
    if (surface.w > 0.0 && abs(temperature - heatBlock.time.z) > heatBlock.waking.y && heatBlock.time.y > 0.0)
        tiles[tile].lastWarm = heatBlock.step.x;

    if (need && tiles[tile].lastNeed != heatBlock.step.x) tiles[tile].lastNeed = heatBlock.step.x;
#ifdef EVAPORATION
    cellArea[cell] = surface.w;
#endif
    cellPower[cell] = power - lost;
    book(slot, gained * heatBlock.time.x, lost * heatBlock.time.x);
}
