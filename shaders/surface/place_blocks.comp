#version 450 core
#extension GL_GOOGLE_include_directive : require
// Gives every listed block its place in the mesh, and the later passes their sizes; one group.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_SCAN_GROUP) in;
#include "surface/scan.glsl"

layout(std430, binding = SURFACE_BIND_BLOCK_SUMS) buffer BlockSums { uvec2 blockSums[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) buffer Commands { SurfaceCommands commands; };

SurfaceDispatch dispatchOver(uint count) {
    return SurfaceDispatch((count + SURFACE_GROUP - 1u) / SURFACE_GROUP, 1u, 1u);
}

void writeCommands(uvec2 total) {
    uvec2 fitting = min(total, setup.limits.zw);
    commands.draw = SurfaceDraw(fitting.y * 3u, 1u, 0u, 0u, 0u);
    commands.vertices = dispatchOver(fitting.x);
    commands.triangles = dispatchOver(fitting.y);
    commands.vertexCount = total.x;
    commands.triangleCount = total.y;
    commands.overflow = uint(fitting != total);
}

void main() {
    uint blocks = commands.blockCount;
    uint share = (blocks + SURFACE_SCAN_GROUP - 1u) / SURFACE_SCAN_GROUP;
    uint begin = min(gl_LocalInvocationIndex * share, blocks), end = min(begin + share, blocks);
    uvec2 own = uvec2(0u);
    for (uint slot = begin; slot < end; ++slot)
        own += blockSums[slot];
    uvec2 total;
    uvec2 place = sumBefore(own, total);
    for (uint slot = begin; slot < end; ++slot) {
        uvec2 count = blockSums[slot];
        blockSums[slot] = place;
        place += count;
    }
    if (gl_LocalInvocationIndex == 0u) writeCommands(total);
}
