#version 450 core
#extension GL_GOOGLE_include_directive : require
// Replaces the row counts of every listed block by running sums and stores the block's totals.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;

layout(std430, binding = SURFACE_BIND_ROW_SUMS) buffer RowSums { uint rowSums[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_SUMS) writeonly buffer BlockSums { uvec2 blockSums[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

void main() {
    uint slot = linearInvocation();
    if (slot >= commands.blockCount) return;
    uint sum = 0u; // vertices below, triangles above: at most 64 * 24 and 64 * 40, so that neither half overflows
    for (uint i = slot * SURFACE_BLOCK_ROWS; i < (slot + 1u) * SURFACE_BLOCK_ROWS; ++i) {
        uint count = rowSums[i];
        rowSums[i] = sum;
        sum += count;
    }
    blockSums[slot] = uvec2(sum & 65535u, sum >> 16);
}
