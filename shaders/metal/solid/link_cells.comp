// Links the solid particles off the lattice into the lists of their coarse cells; BEGIN 1 also gives every solid particle its
// first label.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

#ifndef BEGIN
#define BEGIN 0
#endif

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_LABELS) writeonly buffer Labels { uint label[]; };

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles) return;
    uint bits = phase[slot];
    bool solid = isSolid(bits);
    if (solid && (bits & PHASE_LATTICE) == 0) link(slot, bits, position[slot].xyz);
#if BEGIN
    label[slot] = solid ? slot : FRAGMENT_NO_LABEL;
    if (slot == 0) control.lastChange = 0;
#endif
}
