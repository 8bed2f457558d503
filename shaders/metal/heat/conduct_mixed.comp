#version 450 core
// Net power into each cell of the mixed tiles: conduction with its six neighbours through the Kirchhoff variable, and what
// the sources give. One group a tile. Metal off the lattice shares cells here: a face conducts as the lesser filled of its
// cells allows. The particles themselves lose heat through the free surface later.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat/common.glsl"
#include "metal/heat/neighbours.glsl"
#include "metal/heat/free_surface.glsl"
#include "metal/heat/source.glsl"
#include "metal/heat/ledger.glsl"
layout(std430, binding = HEAT_CELL_POWER) restrict writeonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_SOURCE_SUMS) restrict readonly buffer SourceSums { float sourceSum[]; };

void main() {
    int tile = int(texelFetch(listTexels, heatBlock.tileCount + int(gl_WorkGroupID.x)).x);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    int stamp = stampOf(tile);
    float theta = texelFetch(thetaTexels, thetaBase(stamp, tile) + inside).x;
    if (theta < 0.0) return;
    ivec3 tilePlace = tileCoordinate(tile);
    NeighbourOffsets offsets = neighbourOffsets(tilePlace, inside);
    Neighbours n = readNeighbours(tile, stamp, inside, offsets);
    Inflow inflow = inflowOf(n, theta);
    bool awake = keepsAwake(inflow);
    float weight = weightOf(cell);
    Weights weights = readWeights(cell, offsets);
    inflow.low *= min(vec3(1), min(vec3(weight), weights.low));
    inflow.high *= min(vec3(1), min(vec3(weight), weights.high));
    Power power = powerOf(inflow, n);
    FreeSurface surface = freeSurface(weight, weights);
    float given = 0.0;
    for (int i = 0; i < heatBlock.sourceCount; ++i) {
        HeatSourceData s = heatBlock.sources[i];
        if (reaches(s, tilePlace))
            given += cellWeightIn(s, tilePlace, inside, weight, surface, theta) * sourceScale(s, sourceSum[i]);
    }
    if (awake || given != 0.0) noteActivity(tile, notesOf(tile));
    cellPower[cell] = power.fromMetal + power.fromWalls + given;
    cellTheta[thetaBase(stamp ^ TILE_HALF, tile) + inside] = surface.area;
    book(cell, (power.fromWalls + given) * heatBlock.timeStep, 0.0);
}
