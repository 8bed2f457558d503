#version 450 core
// Adds up the tile sums of each source, in a fixed order: one group a source. The totals stand in front of the tile sums.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "shared/heat.h"
layout(std140, binding = HEAT_BLOCK) uniform Heat { HeatBlock heatBlock; };
layout(std430, binding = HEAT_PARTIAL) restrict buffer Partial { float partial[]; };

shared float sums[GROUP_SIZE];

void main() {
    int source = int(gl_WorkGroupID.x);
    int lane = int(gl_LocalInvocationIndex);
    ivec4 low = heatBlock.sources[source].lowTile;
    int count = heatBlock.sources[source].tileCount.w;
    float sum = 0.0;
    for (int i = lane; i < count; i += GROUP_SIZE) sum += partial[low.w + i];
    sums[lane] = sum;
    for (int half_ = GROUP_SIZE / 2; half_ > 0; half_ /= 2) {
        barrier();
        if (lane < half_) sums[lane] += sums[lane + half_];
    }
    if (lane == 0) partial[source] = sums[0];
}
