// First half of the prefix sum over the cells: how many particles each chunk of cells holds.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic_step.glsl"

layout(local_size_x = CLASSIC_SCAN_GROUP) in;
layout(std430, binding = CLASSIC_CELL_COUNTS) readonly buffer Counts { uvec4 counts[]; };
layout(std430, binding = CLASSIC_CHUNK_SUMS) writeonly buffer Sums { uint chunkSums[]; };

shared uint sums[CLASSIC_SCAN_GROUP];

void main() {
    const uint self = gl_LocalInvocationIndex;
    const uint quads = CLASSIC_SCAN_CELLS / 4 / CLASSIC_SCAN_GROUP;
    const uint first = gl_WorkGroupID.x * (CLASSIC_SCAN_CELLS / 4) + self * quads;
    uvec4 sum = uvec4(0);
    for (uint q = 0; q < quads; ++q)
        sum += counts[first + q]; // the buffer is padded with empty cells to whole chunks
    sums[self] = sum.x + sum.y + sum.z + sum.w;
    barrier();
    if (self != 0) return;
    uint total = 0;
    for (uint i = 0; i < CLASSIC_SCAN_GROUP; ++i)
        total += sums[i];
    chunkSums[gl_WorkGroupID.x] = total;
}
