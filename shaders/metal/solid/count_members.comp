// Counts the members of each fragment at its root and notes whether one of them is clamped.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_LABELS) readonly buffer Labels { uint label[]; };
layout(std430, binding = FRAGMENT_MEMBERS) buffer Members { uint members[]; };

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles || label[slot] == FRAGMENT_NO_LABEL) return;
    atomicAdd(members[label[slot]], 1);
    if ((phase[slot] & PHASE_CLAMPED) != 0) atomicOr(members[label[slot]], FRAGMENT_CLAMPED);
}
