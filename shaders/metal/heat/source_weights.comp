#version 450 core
// Sums the weights of each source over every row of cells that it may reach and that holds metal. An invocation a row: the
// rows' sums are added up later, because on a CPU a barrier here costs more than all the rest.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
#include "shared/heat.h"
layout(local_size_x = GROUP_SIZE / TILE_EDGE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/neighbours.glsl"
#include "metal/heat/free_surface.glsl"
#include "metal/heat/source.glsl"
layout(std430, binding = HEAT_CONTROL) restrict readonly buffer Control { HeatControl control; };
#include "metal/heat/listed_rows.glsl"
layout(std430, binding = HEAT_SOURCE_SUMS) restrict writeonly buffer SourceSums { float sourceSum[]; };

const ivec4 kSources = ivec4(0, 1, 2, 3); // HEAT_SOURCES

void main() {
    if (gl_GlobalInvocationID.x >= control.reachedRows.w) return;
    int listed = listedRow(placeOfMixed(true, gl_GlobalInvocationID.x));
    int tile = listed / TILE_ROWS;
    ivec3 tilePlace = tileCoordinate(tile);
    int row = listed % TILE_ROWS;
    int base = thetaBase(stampOf(tile), tile);
    const int first = nextReaching(tilePlace, 0);
    vec4 sums = vec4(0); // of the sources; SYNCHRONOUS_DRIVER: a vector, as it keeps arrays in memory
    for (int inside = TILE_EDGE * row; inside < TILE_EDGE * (row + 1); ++inside) {
        int cell = tile * TILE_CELLS + inside;
        float theta = texelFetch(thetaTexels, base + inside).x;
        float own = weightOf(cell);
        FreeSurface surface = freeSurface(own, readWeights(cell, neighbourOffsets(tilePlace, inside)));
        for (int i = first; i < heatBlock.sourceCount; i = nextReaching(tilePlace, i + 1)) {
            float weight = cellWeightIn(heatBlock.sources[i], tilePlace, inside, own, surface, theta);
            if (theta >= 0.0) sums += weight * vec4(equal(ivec4(i), kSources));
        }
    }
    for (int i = first; i < heatBlock.sourceCount; i = nextReaching(tilePlace, i + 1)) {
        HeatSourceData s = heatBlock.sources[i];
        int sum = s.firstRowSum + TILE_ROWS * sourceTileIndex(s, tilePlace) + row;
        sourceSum[sum] = dot(sums, vec4(equal(ivec4(i), kSources)));
    }
}
