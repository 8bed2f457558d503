#version 450 core
#extension GL_GOOGLE_include_directive : require
// Gives every listed block its place in the mesh, and the later passes their sizes; one group.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_SCAN_GROUP) in;
#include "surface/scan.glsl"

layout(std430, binding = SURFACE_BIND_BLOCK_STATES) writeonly buffer BlockStates { uint states[]; };
layout(std430, binding = SURFACE_BIND_SETTLED) writeonly buffer Settled { uvec2 settled[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_LIST) readonly buffer BlockList { uint blockList[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_SUMS) buffer BlockSums { uvec2 blockSums[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) buffer Commands { SurfaceCommands commands; };

/// `first`: where the new part of the mesh begins; `total`: where it ends.
void writeCommands(uvec2 first, uvec2 total) {
    uvec2 fitting = min(total, setup.limits.zw);
    commands.draw = SurfaceDraw(fitting.y * 3u, 1u, 0u, 0u, 0u);
    commands.vertices = dispatchOver(fitting.x - first.x);
    commands.triangles = dispatchOver(fitting.y - first.y);
    commands.firstVertex = first.x;
    commands.firstTriangle = first.y;
    commands.vertexCount = total.x;
    commands.triangleCount = total.y;
    commands.overflow = uint(fitting != total);
    if (commands.whole == 0u) return;
    commands.settledVertices = fitting.x;
    commands.settledTriangles = fitting.y;
}

/// Remembers where a block's triangles settle; one without any is forgotten until it is altered.
void settle(uint slot, uvec2 place, uvec2 count) {
    uint block = blockList[slot] & ~SURFACE_LISTED_ALTERED;
    uint first = min(place.y, setup.limits.w);
    settled[block] = uvec2(first, min(count.y, setup.limits.w - first));
    if (count == uvec2(0u)) states[block] = 0u;
}

void main() {
    uint blocks = commands.blockCount;
    uint share = (blocks + SURFACE_SCAN_GROUP - 1u) / SURFACE_SCAN_GROUP;
    uint begin = min(gl_LocalInvocationIndex * share, blocks), end = min(begin + share, blocks);
    uvec2 own = uvec2(0u);
    for (uint slot = begin; slot < end; ++slot)
        own += blockSums[slot];
    uvec2 total;
    bool whole = commands.whole != 0u;
    uvec2 first = whole ? uvec2(0u) : uvec2(commands.settledVertices, commands.settledTriangles);
    uvec2 place = first + sumBefore(own, total);
    for (uint slot = begin; slot < end; ++slot) {
        uvec2 count = blockSums[slot];
        blockSums[slot] = place;
        if (whole) settle(slot, place, count);
        place += count;
    }
    if (gl_LocalInvocationIndex == 0u) writeCommands(first, first + total);
}
