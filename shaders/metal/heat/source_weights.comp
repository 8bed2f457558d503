#version 450 core
// Sums the weights of each source over every mixed tile that it can reach, in a fixed order: one group a tile.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat/common.glsl"
#include "metal/heat/neighbours.glsl"
#include "metal/heat/free_surface.glsl"
#include "metal/heat/source.glsl"
layout(std430, binding = HEAT_SOURCE_SUMS) restrict writeonly buffer SourceSums { float sourceSum[]; };

shared float weights[TILE_CELLS];

void main() {
    int tile = int(texelFetch(listTexels, heatBlock.tileCount + int(gl_WorkGroupID.x)).x);
    ivec3 tilePlace = tileCoordinate(tile);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    float theta = texelFetch(thetaTexels, thetaBase(stampOf(tile), tile) + inside).x;
    float own = weightOf(cell);
    FreeSurface surface = freeSurface(own, readWeights(cell, neighbourOffsets(tilePlace, inside)));
    for (int i = 0; i < heatBlock.sourceCount; ++i) {
        HeatSourceData s = heatBlock.sources[i];
        if (!reaches(s, tilePlace)) continue; // the same for the whole group
        barrier();
        weights[inside] = theta < 0.0 ? 0.0 : cellWeightIn(s, tilePlace, inside, own, surface, theta);
        barrier(); // on a CPU each barrier costs more than one invocation that adds all up
        if (inside == 0) {
            float sum = 0.0;
            for (int j = 0; j < TILE_CELLS; ++j) sum += weights[j];
            sourceSum[s.firstTileSum + sourceTileIndex(s, tilePlace)] = sum;
        }
    }
}
