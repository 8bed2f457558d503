#version 450 core
#extension GL_GOOGLE_include_directive : require
// Decides which blocks are made anew and lists them in their order; one group. A block that was altered once is made
// anew at every update, behind the settled part of the mesh, until the altered blocks are so many that the whole mesh is
// made and settles.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_SCAN_GROUP) in;
#include "surface/scan.glsl"

layout(std430, binding = SURFACE_BIND_BLOCK_FLAGS) buffer BlockFlags { uint flags[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_STATES) buffer BlockStates { uint states[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_LIST) writeonly buffer BlockList { uint blockList[]; };
layout(std430, binding = SURFACE_BIND_SETTLED) buffer Settled { uvec2 settled[]; };
layout(std430, binding = SURFACE_BIND_RETIRED) writeonly buffer Retired { uvec2 retired[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) buffer Commands { SurfaceCommands commands; };

/// Whether this block or one that its cells take vertices from is marked.
bool markedNear(uint block) {
    ivec3 low = blockPlace(int(block)), high = min(low + 1, setup.blocks.xyz - 1);
    uint marks = 0u;
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                marks |= flags[(z * setup.blocks.y + y) * setup.blocks.x + x];
    return marks != 0u;
}

/// Brings the state of the invocation's blocks up to date; how many hold surface and how many of these are remade.
uvec2 updateStates(uint begin, uint end) {
    uvec2 sum = uvec2(0u);
    for (uint block = begin; block < end; ++block) {
        uint state = states[block];
        if (flags[block] != 0u) state |= SURFACE_BLOCK_HELD | SURFACE_BLOCK_ALTERED;
        bool settled_ = setup.options.y == 0 && (state & SURFACE_BLOCK_REMADE) == 0u;
        if (settled_ && markedNear(block)) state |= SURFACE_BLOCK_REMADE;
        states[block] = state;
        sum += uvec2((state & SURFACE_BLOCK_HELD) != 0u, (state & SURFACE_BLOCK_REMADE) != 0u);
    }
    return sum;
}

void listAll(uint begin, uint end, uint slot) {
    for (uint block = begin; block < end; ++block) {
        bool held = (states[block] & SURFACE_BLOCK_HELD) != 0u;
        states[block] = held ? SURFACE_BLOCK_HELD : 0u;
        settled[block] = uvec2(0u);
        if (!held) continue;
        blockList[slot] = block | SURFACE_LISTED_ALTERED;
        retired[slot++] = uvec2(0u);
    }
}

void listRemade(uint begin, uint end, uint slot) {
    for (uint block = begin; block < end; ++block) {
        uint state = states[block];
        if ((state & SURFACE_BLOCK_REMADE) == 0u) continue;
        blockList[slot] = block | ((state & SURFACE_BLOCK_ALTERED) != 0u ? SURFACE_LISTED_ALTERED : 0u);
        retired[slot++] = settled[block];
        settled[block] = uvec2(0u);
    }
}

void main() {
    uint blocks = uint(setup.blocks.w);
    uint share = (blocks + SURFACE_SCAN_GROUP - 1u) / SURFACE_SCAN_GROUP;
    uint begin = min(gl_LocalInvocationIndex * share, blocks), end = min(begin + share, blocks);
    uvec2 total;
    uvec2 before = sumBefore(updateStates(begin, end), total);
    // Remaking costs more a block than making all, and leaves holes in the settled part.
    bool whole = setup.options.y != 0 || commands.overflow != 0u || total.y * 3u > total.x;
    barrier();
    for (uint block = begin; block < end; ++block)
        flags[block] = 0u;
    if (whole)
        listAll(begin, end, before.x);
    else
        listRemade(begin, end, before.y);
    if (gl_LocalInvocationIndex == 0u) {
        uint listed = whole ? total.x : total.y;
        commands.splattedCount = setup.options.y != 0 ? setup.limits.x : commands.changedCount;
        commands.changedCount = 0u;
        commands.changed.x = 0u;
        commands.whole = uint(whole);
        commands.blockCount = listed;
        commands.words = dispatchOver(listed * SURFACE_BLOCK_WORDS);
        commands.rows = dispatchOver(listed * SURFACE_BLOCK_ROWS);
        commands.blocks = dispatchOver(listed);
    }
}
