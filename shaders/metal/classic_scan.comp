// Second half of the prefix sum over the cells: where each cell's particles begin in cell order.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic_step.glsl"

layout(local_size_x = CLASSIC_SCAN_GROUP) in;
layout(std430, binding = CLASSIC_CELL_COUNTS) readonly buffer Counts { uvec4 counts[]; };
layout(std430, binding = CLASSIC_CHUNK_SUMS) readonly buffer Sums { uint chunkSums[]; };
layout(std430, binding = CLASSIC_CELL_STARTS) writeonly buffer Starts { uvec4 starts[]; };

shared uint before[CLASSIC_SCAN_GROUP]; // particles in the chunks before, a share for each invocation
shared uint own[CLASSIC_SCAN_GROUP];    // particles in each invocation's cells

void main() {
    const uint self = gl_LocalInvocationIndex;
    const uint quads = CLASSIC_SCAN_CELLS / 4 / CLASSIC_SCAN_GROUP;
    const uint first = gl_WorkGroupID.x * (CLASSIC_SCAN_CELLS / 4) + self * quads;

    uint share = 0;
    for (uint chunk = self; chunk < gl_WorkGroupID.x; chunk += CLASSIC_SCAN_GROUP)
        share += chunkSums[chunk];
    before[self] = share;
    uvec4 sum = uvec4(0);
    for (uint q = 0; q < quads; ++q)
        sum += counts[first + q];
    own[self] = sum.x + sum.y + sum.z + sum.w;
    barrier();

    uint start = 0;
    for (uint i = 0; i < CLASSIC_SCAN_GROUP; ++i)
        start += before[i] + (i < self ? own[i] : 0u);
    for (uint q = 0; q < quads; ++q) {
        const uvec4 count = counts[first + q];
        const uint second = start + count.x, third = second + count.y, fourth = third + count.z;
        starts[first + q] = uvec4(start, second, third, fourth);
        start = fourth + count.w;
    }
}
