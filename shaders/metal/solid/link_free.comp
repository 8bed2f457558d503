// Links the particles of free fragments into the lists of their coarse cells, after they were moved.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_FREE_SLOTS) readonly buffer FreeSlots { uint freeSlots[]; };

void main() {
    uint entry = linearInvocation();
    if (entry >= control.particles) return;
    uint slot = freeSlots[entry];
    uint bits = phase[slot];
    if (isSolid(bits) && fragmentOf(bits) != 0) link(slot, bits, position[slot].xyz);
}
