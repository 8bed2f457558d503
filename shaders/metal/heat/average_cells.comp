#version 450 core
// Computes the mean Kirchhoff variable of every cell of the tiles that hold metal off the lattice.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat/common.glsl"
#include "metal/heat/cell_range.glsl"
layout(std430, binding = HEAT_CELL_SUMS) restrict readonly buffer CellSums { uint cellSum[]; };

void main() {
    int tile = int(texelFetch(listTexels, offLatticeTilesBegin() + int(gl_WorkGroupID.x)).x);
    int cell = tile * TILE_CELLS + int(gl_LocalInvocationIndex);
    int index = thetaIndex(cell);
    float theta = texelFetch(thetaTexels, index).x;
    uint weight = cellWeight[cell];
    uint own = isEmpty(theta) ? 0u : SHARE_UNIT;
    if (weight == own || isHeld(theta)) return;
    if (own != 0u) addToRange(cell, theta);
    float sum = float(cellSum[cell]) * heatBlock.thetaUnit;
    cellTheta[index] = (sum + float(own / SHARE_UNIT) * theta) / (float(weight) / float(SHARE_UNIT));
}
