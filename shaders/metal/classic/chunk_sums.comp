// First pass of the prefix sum over the cells: particles in each chunk of cells.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/scan.glsl"

layout(std430, binding = CLASSIC_CHUNK_SUMS) writeonly buffer Sums { uint chunkSums[]; };

shared uint sum;

void main() {
    if (gl_LocalInvocationIndex == 0) sum = 0;
    barrier();
    atomicAdd(sum, sumOfOwnCells());
    barrier();
    if (gl_LocalInvocationIndex == 0) chunkSums[gl_WorkGroupID.x] = sum;
}
