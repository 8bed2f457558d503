#version 450 core
// Adds what the sources give to the power of the cells they reach: one group a tile of the box around one source.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#define MIXED
#include "metal/heat_common.glsl"
#include "metal/heat_source.glsl"
#include "metal/heat_ledger.glsl"
layout(std430, binding = HEAT_CELL_POWER) restrict buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_PARTIAL) restrict readonly buffer Partial { float partial[]; };
uniform int source;

void main() {
    HeatSourceData s = heatBlock.sources[source];
    ivec3 tilePlace = sourceTile(s, int(gl_WorkGroupID.x));
    int tile = tileIndex(tilePlace);
    int inside = int(gl_LocalInvocationIndex);
    int cell = tile * TILE_CELLS + inside;
    if (cellTheta[cell] < 0.0) return;
    float given = cellWeightIn(s, tile, tilePlace, inside) * sourceScale(s, partial[source]);
    if (given == 0.0) return;
    tiles[tile].lastNeed = heatBlock.step.x;
    cellPower[cell] += given;
    book(cell, given * heatBlock.time.x, 0.0);
}
