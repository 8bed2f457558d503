#version 450 core
// Adds up the row sums of each source, in a fixed order: one group a source. The totals stand in front of the row sums. Tiles
// without metal take no part and have no sum; of the others, rows without metal have 0.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
layout(std430, binding = HEAT_SOURCE_SUMS) restrict buffer SourceSums { float sourceSum[]; };

shared float sums[GROUP_SIZE];

float tileSum(int firstRow) {
    float sum = 0.0;
    for (int row = 0; row < TILE_ROWS; ++row) sum += sourceSum[firstRow + row];
    return sum;
}

void main() {
    int source = int(gl_WorkGroupID.x);
    int lane = int(gl_LocalInvocationIndex);
    HeatSourceData s = heatBlock.sources[source];
    float sum = 0.0;
    for (int i = lane; i < s.tileCount; i += GROUP_SIZE)
        if (tookPart(stampOf(tileIndex(sourceTile(s, i))), heatBlock.stepNumber)) sum += tileSum(s.firstRowSum + TILE_ROWS * i);
    sums[lane] = sum;
    barrier();
    if (lane != 0) return;
    for (int i = 1; i < GROUP_SIZE; ++i) sum += sums[i];
    sourceSum[source] = sum;
}
