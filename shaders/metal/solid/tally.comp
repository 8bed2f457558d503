// Counts the members of each piece at its root and notes whether one of them is clamped.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_LABEL) readonly buffer Labels { uint label[]; };
layout(std430, binding = PIECES_TALLY) buffer Tallies { uint tally[]; };

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles || label[slot] == PIECE_NONE) return;
    atomicAdd(tally[label[slot]], 1);
    if ((phase[slot] & PHASE_CLAMPED) != 0) atomicOr(tally[label[slot]], 0x80000000u);
}
