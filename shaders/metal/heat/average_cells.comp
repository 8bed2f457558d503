#version 450 core
// Computes the mean Kirchhoff variable and the weight of every cell of the tiles that hold metal off the lattice.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat/common.glsl"
layout(std430, binding = HEAT_CELL_SUMS) restrict readonly buffer CellSums { CellSum cellSums[]; };

void main() {
    int tile = int(texelFetch(listTexels, 2 * heatBlock.tileCount + int(gl_WorkGroupID.x)).x);
    int cell = tile * TILE_CELLS + int(gl_LocalInvocationIndex);
    int index = thetaIndex(cell);
    CellSum sum = cellSums[cell];
    float theta = texelFetch(thetaTexels, index).x;
    if (sum.weight == 0u || isHeld(theta)) return;
    float offLattice = float(sum.weight) / SHARE_UNIT;
    float own = isEmpty(theta) ? 0.0 : 1.0;
    float total = offLattice + own;
    cellTheta[index] = (float(sum.theta) * heatBlock.thetaUnit + own * theta) / total;
    cellWeight[cell] = total;
}
