#version 450 core
// Makes the mean Kirchhoff variable and the weight of every cell of the tiles that loose metal is in.
#extension GL_GOOGLE_include_directive : require
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS) in;
#include "metal/heat/common.glsl"
layout(std430, binding = HEAT_CELL_SUMS) restrict readonly buffer CellSums { HeatSum cellSums[]; };

void main() {
    int tile = int(texelFetch(listTexels, 2 * heatBlock.step.w + int(gl_WorkGroupID.x)).x);
    int cell = tile * TILE_CELLS + int(gl_LocalInvocationIndex);
    int place = thetaPlace(cell);
    HeatSum sum = cellSums[cell];
    float theta = texelFetch(thetaTexels, place).x;
    if (sum.weight == 0u || isHeld(theta)) return;
    float loose = float(sum.weight) / LOOSE_UNIT;
    float own = isEmpty(theta) ? 0.0 : 1.0;
    float total = loose + own;
    cellTheta[place] = (float(sum.theta) * heatBlock.loose.x + own * theta) / total;
    cellWeight[cell] = total;
}
