// Second pass of the prefix sum over the cells: index of each cell's first particle in cell order.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/scan.glsl"

layout(std430, binding = CLASSIC_CHUNK_SUMS) readonly buffer Sums { uint chunkSums[]; };
layout(std430, binding = CLASSIC_CELL_STARTS) writeonly buffer Starts { uvec4 starts[]; };

shared uint chunkStart;
shared uint scanned[2][CLASSIC_SCAN_GROUP];

/// Sum over this and all earlier invocations of the group; Hillis and Steele 1986.
uint sumUpTo(uint self, uint value) {
    uint side = 0;
    for (uint stride = 1; stride < CLASSIC_SCAN_GROUP; stride *= 2) {
        scanned[side][self] = value;
        barrier();
        if (self >= stride) value += scanned[side][self - stride];
        side = 1 - side;
    }
    return value;
}

void main() {
    const uint self = gl_LocalInvocationIndex;
    if (self == 0) chunkStart = 0;
    const uint own = sumOfOwnCells();
    const uint upToHere = sumUpTo(self, own);
    uint before = 0; // particles in the earlier chunks that this invocation adds
    for (uint chunk = self; chunk < gl_WorkGroupID.x; chunk += CLASSIC_SCAN_GROUP)
        before += chunkSums[chunk];
    if (before > 0) atomicAdd(chunkStart, before);
    barrier();

    uint start = chunkStart + upToHere - own;
    for (uint q = 0; q < kQuads; ++q) {
        const uvec4 count = texelFetch(countTexels, int(firstQuad() + q));
        const uint second = start + count.x, third = second + count.y, fourth = third + count.z;
        starts[firstQuad() + q] = uvec4(start, second, third, fourth);
        start = fourth + count.w;
    }
}
