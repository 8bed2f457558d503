// Prefix sum over the cells: each work group sums one chunk, each invocation some cells of it.
#include "shared/classic.h"

layout(local_size_x = CLASSIC_SCAN_GROUP) in;
layout(binding = CLASSIC_COUNT_TEXELS) uniform usamplerBuffer countTexels; // four cells a texel, padded to whole chunks

const uint kQuads = CLASSIC_SCAN_CELLS / 4 / CLASSIC_SCAN_GROUP; // texels of an invocation

uint firstQuad() {
    return gl_WorkGroupID.x * (CLASSIC_SCAN_CELLS / 4) + gl_LocalInvocationIndex * kQuads;
}

uint sumOfOwnCells() {
    uvec4 sum = uvec4(0);
    for (uint q = 0; q < kQuads; ++q)
        sum += texelFetch(countTexels, int(firstQuad() + q));
    return sum.x + sum.y + sum.z + sum.w;
}
