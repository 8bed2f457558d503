// Lists the particles of free fragments in ascending order and sets the sizes of the passes that move them. One group.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_FREE_SLOTS) writeonly buffer FreeSlots { uint freeSlots[]; };

#include "metal/solid/prefix_sum.glsl"

uvec4 groups(uint count) { return uvec4((count + FRAGMENT_GROUP - 1) / FRAGMENT_GROUP, 1, 1, 0); }

bool isFree(uint bits) { return isSolid(bits) && fragmentOf(bits) != 0; }

void main() {
    uint lane = gl_LocalInvocationID.x;
    uint first = runStart(lane);
    uint end = runStart(lane + 1);
    uint mine = 0;
    for (uint slot = first; slot < end; ++slot) mine += isFree(phase[slot]) ? 1 : 0;
    uint found;
    uint place = sumBefore(mine, found);
    if (mine != 0)
        for (uint slot = first; slot < end; ++slot)
            if (isFree(phase[slot])) freeSlots[place++] = slot;
    if (lane != 0) return;
    control.particles = found;
    control.particleGroups = groups(found);
    control.fragmentGroups = uvec4(found == 0 ? 0 : control.fragments, 1, 1, 0);
    control.slotGroups = found == 0 ? uvec4(0, 1, 1, 0) : groups(counters.particles);
    control.cellGroups = found == 0 ? uvec4(0, 1, 1, 0) : groups(coarseCellCount());
}
