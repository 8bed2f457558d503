#version 450 core
#extension GL_GOOGLE_include_directive : require
// Computes the first vertices and triangles of every listed block, and the sizes of the later passes; one group.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_SCAN_GROUP) in;
#include "surface/scan.glsl"

layout(std430, binding = SURFACE_BIND_BLOCK_STATES) writeonly buffer BlockStates { uint states[]; };
layout(std430, binding = SURFACE_BIND_BASE_TRIANGLES) writeonly buffer BaseTriangles { uvec2 baseTriangles[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_LIST) readonly buffer BlockList { uint blockList[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_SUMS) buffer BlockSums { uvec2 blockSums[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) buffer Commands { SurfaceCommands commands; };

/// `first`, `total`: first vertex and triangle of the part that this update makes, and of the part behind it.
void writeCommands(uvec2 first, uvec2 total) {
    uvec2 fitting = min(total, uvec2(setup.maxVertices, setup.maxTriangles));
    commands.draw = SurfaceDraw(fitting.y * 3u, 1u, 0u, 0u, 0u);
    commands.vertices = dispatchOver(fitting.x - first.x);
    commands.triangles = dispatchOver(fitting.y - first.y);
    commands.firstVertex = first.x;
    commands.firstTriangle = first.y;
    commands.vertexCount = total.x;
    commands.triangleCount = total.y;
    commands.overflow = uint(fitting != total);
    if (commands.rebuilt == 0u) return;
    commands.baseVertices = fitting.x;
    commands.baseTriangles = fitting.y;
}

/// Stores the block's triangles in the base part. A block without triangles is no longer occupied.
void storeBaseTriangles(uint slot, uvec2 place, uvec2 count) {
    uint block = blockList[slot] & ~SURFACE_LISTED_WITH_VERTICES;
    uint first = min(place.y, setup.maxTriangles);
    baseTriangles[block] = uvec2(first, min(count.y, setup.maxTriangles - first));
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
    bool rebuilt = commands.rebuilt != 0u;
    uvec2 first = rebuilt ? uvec2(0u) : uvec2(commands.baseVertices, commands.baseTriangles);
    uvec2 place = first + sumBefore(own, total);
    for (uint slot = begin; slot < end; ++slot) {
        uvec2 count = blockSums[slot];
        blockSums[slot] = place;
        if (rebuilt) storeBaseTriangles(slot, place, count);
        place += count;
    }
    if (gl_LocalInvocationIndex == 0u) writeCommands(first, first + total);
}
