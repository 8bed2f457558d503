// Writes each particle's piece, takes what came loose off the lattice and stops what a clamp holds. A cycle whose labels
// were still changing in the last round writes nothing.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_LABEL) readonly buffer Labels { uint label[]; };
layout(std430, binding = PIECES_NUMBER) readonly buffer Numbers { uint number[]; };

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles || control.changed == PIECES_ROUNDS) return;
    uint bits = phase[slot];
    if (!solid(bits)) {
        phase[slot] = bits & ~(PIECE_BITS | PHASE_FRESH);
        return;
    }
    if (label[slot] == PIECE_NONE) return; // froze after this cycle began
    uint piece = number[label[slot]];
    bits = (bits & ~(PIECE_BITS | PHASE_FRESH)) | (piece << PHASE_PIECE_SHIFT);
    if (piece == 0) velocity[slot].xyz = vec3(0);
    if (piece != 0 && (bits & PHASE_LATTICE) != 0) {
        latticeSlot[latticeIndex(latticeCell(position[slot].xyz))] = 0;
        bits &= ~PHASE_LATTICE;
    }
    phase[slot] = bits;
}
