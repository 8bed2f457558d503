#version 450 core
// Sums the weights of each source over the cells that it may reach, in a fixed order: one group a source. Tiles without metal
// take no part.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/neighbours.glsl"
#include "metal/heat/free_surface.glsl"
#include "metal/heat/source.glsl"
layout(std430, binding = HEAT_SOURCE_SUMS) restrict writeonly buffer SourceSums { float sourceSum[]; };

shared float sums[GROUP_SIZE];

/// Sum of the weights of the four cells of a row; `base`: index of the tile's theta.
float rowSum(HeatSourceData s, int tile, ivec3 tilePlace, int base, int row) {
    float sum = 0.0;
    for (int inside = TILE_EDGE * row; inside < TILE_EDGE * (row + 1); ++inside) {
        float theta = texelFetch(thetaTexels, base + inside).x;
        if (theta < 0.0) continue;
        int cell = tile * TILE_CELLS + inside;
        float own = weightOf(cell);
        FreeSurface surface = freeSurface(own, readWeights(cell, neighbourOffsets(tilePlace, inside)));
        sum += cellWeightIn(s, tilePlace, inside, own, surface, theta);
    }
    return sum;
}

float tileSum(HeatSourceData s, int number) {
    ivec3 tilePlace = sourceTile(s, number);
    int tile = tileIndex(tilePlace);
    int stamp = stampOf(tile);
    if (!tookPart(stamp, heatBlock.stepNumber)) return 0.0;
    float sum = 0.0;
    for (int row = 0; row < TILE_ROWS; ++row) sum += rowSum(s, tile, tilePlace, thetaBase(stamp, tile), row);
    return sum;
}

void main() {
    int source = int(gl_WorkGroupID.x);
    int lane = int(gl_LocalInvocationIndex);
    HeatSourceData s = heatBlock.sources[source];
    float sum = 0.0;
    for (int i = lane; i < s.tileCount; i += GROUP_SIZE) sum += tileSum(s, i);
    sums[lane] = sum;
    barrier();
    if (lane != 0) return;
    for (int i = 1; i < GROUP_SIZE; ++i) sum += sums[i];
    sourceSum[source] = sum;
}
