// Chains the solid particles off the lattice into their coarse cells; BEGIN 1 also gives every solid its first label.
// The order within a chain is open: every sum over one is in integers, every choice a minimum.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

#ifndef BEGIN
#define BEGIN 0
#endif

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_LABEL) writeonly buffer Labels { uint label[]; };
layout(std430, binding = PIECES_TALLY) writeonly buffer Tallies { uint tally[]; };

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles) return;
    uint bits = phase[slot];
    bool isSolid = solid(bits);
    if (isSolid && (bits & PHASE_LATTICE) == 0)
        next[slot] = atomicExchange(head[coarseIndex(coarseCell(position[slot].xyz))], slot + 1);
#if BEGIN
    label[slot] = isSolid ? slot : PIECE_NONE;
    tally[slot] = 0;
    if (slot == 0) control.changed = 0;
#endif
}
