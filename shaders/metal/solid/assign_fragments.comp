// Writes the number of its fragment to each particle, takes particles of free fragments off the lattice and stops those of
// clamped ones.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_LABELS) readonly buffer Labels { uint label[]; };
layout(std430, binding = FRAGMENT_MEMBERS) readonly buffer Numbers { uint number[]; };

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles) return;
    uint bits = phase[slot];
    if (!isSolid(bits)) {
        phase[slot] = bits & ~(PHASE_FRAGMENT_BITS | PHASE_FRESH);
        return;
    }
    if (label[slot] == FRAGMENT_NO_LABEL) return; // froze after this cycle began
    uint fragment = number[label[slot]];
    bits = (bits & ~(PHASE_FRAGMENT_BITS | PHASE_FRESH)) | (fragment << PHASE_FRAGMENT_SHIFT);
    if (fragment == 0) velocity[slot].xyz = vec3(0);
    if (fragment != 0 && (bits & PHASE_LATTICE) != 0) {
        latticeSlot[latticeIndex(latticeCell(position[slot].xyz))] = 0;
        bits &= ~PHASE_LATTICE;
    }
    phase[slot] = bits;
}
