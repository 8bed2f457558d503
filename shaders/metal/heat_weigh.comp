#version 450 core
// Sums the weights of one source over each tile it can reach, in a fixed order: one group a tile.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat_common.glsl"
#include "metal/heat_source.glsl"
layout(std430, binding = HEAT_PARTIAL) restrict writeonly buffer Partial { float partial[]; };

shared float weights[TILE_CELLS];

void main() {
    int source = int(gl_WorkGroupID.y);
    int group = int(gl_WorkGroupID.x);
    HeatSourceData s = heatBlock.sources[source];
    if (group >= s.tileCount.w) return;
    ivec3 tilePlace = sourceTile(s, group);
    int tile = tileIndex(tilePlace);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    float theta = texelFetch(thetaTexels, thetaPlace(cell)).x;
    float own = texelFetch(weightTexels, cell).x;
    vec4 surface = freeSurface(own, readWeights(cell, cellsBeside(tilePlace, inside)));
    weights[inside] = theta < 0.0 ? 0.0 : cellWeightIn(s, tilePlace, inside, own, surface, theta);
    for (int half_ = TILE_CELLS / 2; half_ > 0; half_ /= 2) {
        barrier();
        if (inside < half_) weights[inside] += weights[inside + half_];
    }
    if (inside == 0) partial[s.lowTile.w + group] = weights[0];
}
