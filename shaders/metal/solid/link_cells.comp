// Links the solid particles off the lattice into the lists of their coarse cells.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles) return;
    uint bits = phase[slot];
    if (isSolid(bits) && (bits & PHASE_LATTICE) == 0) link(slot, bits, position[slot].xyz);
}
