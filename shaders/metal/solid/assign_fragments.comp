// Writes the number of its fragment to each particle, takes particles of free fragments off the lattice and stops those
// of clamped ones. Lists the slots that may have become or ceased to be moving metal: those with changed bits, and
// metal that froze lately, which moves as long as it flies.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_LABELS) readonly buffer Labels { uint label[]; };
layout(std430, binding = FRAGMENT_MEMBERS) readonly buffer Numbers { uint number[]; };

#define PHASE_CHANGES_BINDING FRAGMENT_CHANGES
#include "metal/phase_changes.glsl"

/// Phase bits of a solid particle that belongs to a fragment; takes it off the lattice if that is free.
uint bitsInFragment(uint slot, uint bits, uint fragment) {
    bits = (bits & ~(PHASE_FRAGMENT_BITS | PHASE_FRESH)) | (fragment << PHASE_FRAGMENT_SHIFT);
    if (fragment == 0) velocity[slot].xyz = vec3(0);
    if (fragment == 0 || (bits & PHASE_LATTICE) == 0u) return bits;
    latticeSlot[latticeIndex(latticeCell(position[slot].xyz))] = 0;
    return bits & ~PHASE_LATTICE;
}

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles) return;
    uint before = phase[slot];
    uint bits = before;
    if (!isSolid(bits))
        bits &= ~(PHASE_FRAGMENT_BITS | PHASE_FRESH);
    else if (label[slot] != FRAGMENT_NO_LABEL) // otherwise it froze after this cycle began
        bits = bitsInFragment(slot, bits, number[label[slot]]);
    if (bits != before) phase[slot] = bits;
    if (bits != before || (bits & PHASE_FRESH) != 0u) listPhaseChange(slot);
}
