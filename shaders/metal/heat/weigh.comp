#version 450 core
// Sums the weights of each source over every mixed tile that it can reach, in a fixed order: one group a tile.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat/common.glsl"
#include "metal/heat/source.glsl"
layout(std430, binding = HEAT_PARTIAL) restrict writeonly buffer Partial { float partial[]; };

shared float weights[TILE_CELLS];

void main() {
    int tile = int(texelFetch(listTexels, heatBlock.step.w + int(gl_WorkGroupID.x)).x);
    ivec3 tilePlace = tileCoordinate(tile);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    float theta = texelFetch(thetaTexels, thetaBase(stampOf(tile), tile) + inside).x;
    float own = texelFetch(weightTexels, cell).x;
    vec4 surface = freeSurface(own, readWeights(cell, cellsBeside(tilePlace, inside)));
    for (int i = 0; i < heatBlock.step.y; ++i) {
        HeatSourceData s = heatBlock.sources[i];
        if (!reaches(s, tilePlace)) continue; // the same for the whole group
        barrier();
        weights[inside] = theta < 0.0 ? 0.0 : cellWeightIn(s, tilePlace, inside, own, surface, theta);
        barrier(); // few of them: each costs more, on a CPU, than one invocation adding all up
        if (inside == 0) {
            float sum = 0.0;
            for (int j = 0; j < TILE_CELLS; ++j) sum += weights[j];
            partial[s.lowTile.w + sourcePlace(s, tilePlace)] = sum;
        }
    }
}
