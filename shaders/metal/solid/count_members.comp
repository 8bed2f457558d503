// Gives each particle its root for a label. Counts the members of each fragment there and records whether one of them
// is clamped.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_LABELS) buffer Labels { uint label[]; };
layout(std430, binding = FRAGMENT_MEMBERS) buffer Members { uint members[]; };

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles) return;
    uint own = label[slot];
    if (own == FRAGMENT_NO_LABEL) return;
    uint root = own;
    for (uint above = label[root]; above != root; above = label[root]) root = above; // others may lower some to it
    if (root != own) label[slot] = root;
    atomicAdd(members[root], 1);
    if ((phase[slot] & PHASE_CLAMPED) != 0) atomicOr(members[root], FRAGMENT_CLAMPED);
}
