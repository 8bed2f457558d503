#version 450 core
// Net power into each cell of the mixed tiles: conduction with its six neighbours through the Kirchhoff variable, and what
// the sources give. One group a tile. Loose metal shares cells here: a face conducts as the lesser filled of its cells allows,
// and what the surface loses is left to the particles.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat/common.glsl"
#include "metal/heat/source.glsl"
#include "metal/heat/ledger.glsl"
layout(std430, binding = HEAT_CELL_AREA) restrict writeonly buffer CellArea { float cellArea[]; };
layout(std430, binding = HEAT_CELL_POWER) restrict writeonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_PARTIAL) restrict readonly buffer Partial { float partial[]; };

void main() {
    int tile = int(texelFetch(listTexels, heatBlock.step.w + int(gl_WorkGroupID.x)).x);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    int stamp = stampOf(tile);
    float theta = texelFetch(thetaTexels, thetaBase(stamp, tile) + inside).x;
    if (theta < 0.0) return;
    ivec3 tilePlace = tileCoordinate(tile);
    Beside beside = cellsBeside(tilePlace, inside);
    Neighbours n = readNeighbours(tile, stamp, inside, beside);
    Inflow inflow = inflowOf(n, theta);
    bool need = keepsAwake(inflow);
    float weight = texelFetch(weightTexels, cell).x;
    Weights weights = readWeights(cell, beside);
    inflow.low *= min(vec3(1), min(vec3(weight), weights.low));
    inflow.high *= min(vec3(1), min(vec3(weight), weights.high));
    vec2 power = powerOf(inflow, n);
    vec4 surface = freeSurface(weight, weights);
    float given = 0.0;
    for (int i = 0; i < heatBlock.step.y; ++i) {
        HeatSourceData s = heatBlock.sources[i];
        if (reaches(s, tilePlace))
            given += cellWeightIn(s, tilePlace, inside, weight, surface, theta) * sourceScale(s, partial[i]);
    }
    if (need || given != 0.0) noteNeed(tile, notesOf(tile));
    cellArea[cell] = surface.w;
    cellPower[cell] = power.x + power.y + given;
    book(cell, (power.y + given) * heatBlock.time.x, 0.0);
}
