#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the blocks whose mesh this update makes, in rising order; one group.
//
// A block that changed once since the last rebuild is meshed again by every update, behind the base part of the mesh.
// When a third of the occupied blocks is meshed in this way, the whole mesh is rebuilt and becomes the base part.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_SCAN_GROUP) in;
#include "surface/scan.glsl"

layout(std430, binding = SURFACE_BIND_BLOCK_FLAGS) buffer BlockFlags { uint flags[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_STATES) buffer BlockStates { uint states[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_LIST) writeonly buffer BlockList { uint blockList[]; };
layout(std430, binding = SURFACE_BIND_BASE_TRIANGLES) buffer BaseTriangles { uvec2 baseTriangles[]; };
layout(std430, binding = SURFACE_BIND_OBSOLETE_TRIANGLES) writeonly buffer ObsoleteTriangles { uvec2 obsoleteTriangles[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) buffer Commands { SurfaceCommands commands; };

/// True if this block, or one whose vertices its cells use, is marked.
bool isMarked(uint block) {
    ivec3 low = blockCoordinates(int(block)), high = min(low + 1, setup.blocks - 1);
    uint marks = 0u;
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                marks |= flags[(z * setup.blocks.y + y) * setup.blocks.x + x];
    return marks != 0u;
}

/// Updates the states of the invocation's blocks. Returns the numbers of occupied blocks and of blocks that are meshed
/// again.
uvec2 updateStates(uint begin, uint end) {
    uvec2 sum = uvec2(0u);
    for (uint block = begin; block < end; ++block) {
        uint state = states[block];
        if (flags[block] != 0u) state |= SURFACE_BLOCK_OCCUPIED | SURFACE_BLOCK_CHANGED;
        bool inBase = setup.rebuild == 0 && (state & SURFACE_BLOCK_REMESHED) == 0u;
        if (inBase && isMarked(block)) state |= SURFACE_BLOCK_REMESHED;
        states[block] = state;
        sum += uvec2((state & SURFACE_BLOCK_OCCUPIED) != 0u, (state & SURFACE_BLOCK_REMESHED) != 0u);
    }
    return sum;
}

void listOccupied(uint begin, uint end, uint slot) {
    for (uint block = begin; block < end; ++block) {
        bool occupied = (states[block] & SURFACE_BLOCK_OCCUPIED) != 0u;
        states[block] = occupied ? SURFACE_BLOCK_OCCUPIED : 0u;
        baseTriangles[block] = uvec2(0u);
        if (!occupied) continue;
        blockList[slot] = block | SURFACE_LISTED_WITH_VERTICES;
        obsoleteTriangles[slot++] = uvec2(0u);
    }
}

void listRemeshed(uint begin, uint end, uint slot) {
    for (uint block = begin; block < end; ++block) {
        uint state = states[block];
        if ((state & SURFACE_BLOCK_REMESHED) == 0u) continue;
        blockList[slot] = block | ((state & SURFACE_BLOCK_CHANGED) != 0u ? SURFACE_LISTED_WITH_VERTICES : 0u);
        obsoleteTriangles[slot++] = baseTriangles[block];
        baseTriangles[block] = uvec2(0u);
    }
}

void main() {
    uint blocks = uint(setup.blockCount);
    uint share = (blocks + SURFACE_SCAN_GROUP - 1u) / SURFACE_SCAN_GROUP;
    uint begin = min(gl_LocalInvocationIndex * share, blocks), end = min(begin + share, blocks);
    uvec2 total;
    uvec2 before = sumBefore(updateStates(begin, end), total);
    // Meshing a block again costs more than its share of a rebuild, and leaves empty triangles in the base part.
    bool rebuild = setup.rebuild != 0 || commands.overflow != 0u || total.y * 3u > total.x;
    barrier();
    for (uint block = begin; block < end; ++block)
        flags[block] = 0u;
    if (rebuild)
        listOccupied(begin, end, before.x);
    else
        listRemeshed(begin, end, before.y);
    if (gl_LocalInvocationIndex == 0u) {
        uint listed = rebuild ? total.x : total.y;
        commands.splattedCount = setup.rebuild != 0 ? setup.particleCount : commands.changedCount;
        commands.changedCount = 0u;
        commands.changed.x = 0u;
        commands.rebuilt = uint(rebuild);
        commands.blockCount = listed;
        commands.words = dispatchOver(listed * SURFACE_BLOCK_WORDS);
        commands.rows = dispatchOver(listed * SURFACE_BLOCK_ROWS);
        commands.blocks = dispatchOver(listed);
    }
}
