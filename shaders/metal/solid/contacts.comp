// Sums up the contacts of each particle of a free fragment, counts those of each fragment and finds its permitted way.
// Sums of particles beyond the capacity are not stored: rigid_motion.comp computes them again.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"
#include "metal/solid/contact_sums.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_FREE_SLOTS) readonly buffer FreeSlots { uint freeSlots[]; };
layout(std430, binding = FRAGMENT_CONTACTS) writeonly buffer Contacts { FragmentContact contact[]; };
layout(std430, binding = FRAGMENT_MOTIONS) buffer Motions { FragmentMotion motion[]; };

void main() {
    uint entry = linearInvocation();
    if (entry >= control.particles) return;
    uint slot = freeSlots[entry];
    FragmentContact sum = contactsOf(slot);
    if (sum.fixedContacts != 0) atomicAdd(motion[fragmentOf(phase[slot])].fixedContacts, uint(sum.fixedContacts));
    if (entry < fragmentBlock.contactRoom) contact[entry] = sum;
    if (!isSolid(phase[slot])) return;
    const uint heldBack = uint((1 - freeShare(position[slot].xyz, velocity[slot].xyz, sum)) * FRAGMENT_WAY_UNIT);
    if (heldBack != 0) atomicMax(motion[fragmentOf(phase[slot])].heldBack, heldBack);
}
