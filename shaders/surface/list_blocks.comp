#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the marked blocks in their order; one group.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_SCAN_GROUP) in;
#include "surface/scan.glsl"

layout(std430, binding = SURFACE_BIND_BLOCK_FLAGS) readonly buffer BlockFlags { uint flags[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_LIST) writeonly buffer BlockList { uint blockList[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) writeonly buffer Commands { SurfaceCommands commands; };

SurfaceDispatch dispatchOver(uint count) {
    return SurfaceDispatch((count + SURFACE_GROUP - 1u) / SURFACE_GROUP, 1u, 1u);
}

void main() {
    uint blocks = uint(setup.blocks.w);
    uint share = (blocks + SURFACE_SCAN_GROUP - 1u) / SURFACE_SCAN_GROUP;
    uint begin = min(gl_LocalInvocationIndex * share, blocks), end = min(begin + share, blocks);
    uint marked = 0u;
    for (uint block = begin; block < end; ++block)
        marked += flags[block];
    uvec2 total;
    uint slot = sumBefore(uvec2(marked, 0u), total).x;
    for (uint block = begin; block < end; ++block)
        if (flags[block] != 0u) blockList[slot++] = block;
    if (gl_LocalInvocationIndex == 0u) {
        commands.blockCount = total.x;
        commands.words = dispatchOver(total.x * SURFACE_BLOCK_WORDS);
        commands.rows = dispatchOver(total.x * SURFACE_BLOCK_ROWS);
        commands.blocks = dispatchOver(total.x);
    }
}
