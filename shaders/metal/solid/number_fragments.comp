// Replaces the number of members at each root by the number of its fragment. Free fragments are numbered in the order
// of their roots. Clamped fragments get 0, and so do free ones beyond FRAGMENT_MAX_COUNT, which do not move until a
// number is free. One group.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_MEMBERS) buffer Members { uint members[]; };

#include "metal/solid/prefix_sum.glsl"

bool isFreeRoot(uint slot) { return members[slot] != 0 && (members[slot] & FRAGMENT_CLAMPED) == 0; }

void main() {
    uint lane = gl_LocalInvocationID.x;
    uint first = runStart(lane);
    uint end = runStart(lane + 1);
    uint mine = 0;
    for (uint slot = first; slot < end; ++slot) mine += isFreeRoot(slot) ? 1 : 0;
    uint found;
    uint own = sumBefore(mine, found);
    for (uint slot = first; slot < end; ++slot) {
        bool counts = isFreeRoot(slot);
        own += counts ? 1 : 0;
        members[slot] = counts && own <= FRAGMENT_MAX_COUNT ? own : 0;
    }
    if (lane != 0) return;
    control.fragments = min(found, FRAGMENT_MAX_COUNT);
    control.rejected = found - control.fragments;
}
