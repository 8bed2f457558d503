// Moves the particles of free fragments as rigid bodies, with exact rotations so that a fragment keeps its shape.
// Empties their lists, which link_free.comp fills again.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"
#include "metal/solid/rotation.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_FREE_SLOTS) readonly buffer FreeSlots { uint freeSlots[]; };
layout(std430, binding = FRAGMENT_MOTIONS) readonly buffer Motions { FragmentMotion motion[]; };

void main() {
    uint entry = linearInvocation();
    if (entry >= control.particles) return;
    uint slot = freeSlots[entry];
    uint bits = phase[slot];
    if (!isSolid(bits) || fragmentOf(bits) == 0) return;
    head[freeList(coarseIndex(coarseCell(position[slot].xyz)))] = 0;
    FragmentMotion body = motion[fragmentOf(bits)];
    float dt = fragmentBlock.timeStep * body.wayShare;
    vec3 arm = rotated(position[slot].xyz - body.centre, body.angularVelocity * dt);
    // Contacts give way if metal presses on both sides: metal left outside the space moves to its edge.
    position[slot].xyz = clamp(body.centre + body.velocity * dt + arm, fragmentBlock.low, fragmentBlock.high);
    velocity[slot].xyz = body.velocity + cross(body.endAngularVelocity, arm);
}
