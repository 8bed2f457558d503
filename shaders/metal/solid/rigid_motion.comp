// The motion of each free fragment as a rigid body: linear and angular momentum of its particles, then gravity,
// contacts and friction over one step. One group a fragment; sums in the fixed order of the list of free slots.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"
#include "metal/solid/contact_sums.glsl"
#include "metal/solid/rotation.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(std430, binding = FRAGMENT_FREE_SLOTS) readonly buffer FreeSlots { uint freeSlots[]; };
layout(std430, binding = FRAGMENT_CONTACTS) readonly buffer Contacts { FragmentContact contact[]; };
layout(std430, binding = FRAGMENT_MOTIONS) buffer Motions { FragmentMotion motion[]; };

// The spring is shared out over the contacts so that a fragment of any size turns around in the same few steps.
const float kSpring = 0.2;
const float kDamper = 0.5;

shared vec4 sums[FRAGMENT_GROUP];

/// Smallest power of two that is no less than the number of lanes with a particle.
uint busyLanes() {
    uint lanes = 1;
    while (lanes < min(control.particles, uint(FRAGMENT_GROUP))) lanes *= 2;
    return lanes;
}

/// Sum over the group, in the order of a binary tree; the other lanes have nothing to add.
vec4 total(vec4 value) {
    uint lane = gl_LocalInvocationID.x;
    barrier();
    sums[lane] = value;
    barrier();
    for (uint reach = busyLanes() / 2; reach > 0; reach /= 2) {
        if (lane < reach) sums[lane] += sums[lane + reach];
        barrier();
    }
    return sums[0];
}

bool isMember(uint entry, uint fragment) {
    uint bits = phase[freeSlots[entry]];
    return isSolid(bits) && fragmentOf(bits) == fragment;
}

FragmentContact contactAt(uint entry) {
    if (entry < fragmentBlock.contactRoom) return contact[entry];
    return contactsOf(freeSlots[entry]);
}

/// Acceleration of a particle by its contacts, for its share of the fragment's stiffness.
vec3 contactForce(uint entry, float share) {
    float dt = fragmentBlock.timeStep;
    FragmentContact c = contactAt(entry);
    vec3 spring = kSpring * share / (dt * dt) * vec3(c.overlap) * 1e-9;
    vec3 normal = spring - kDamper * share / dt * vec3(c.normalVelocity) * 1e-6;
    if (dot(normal, spring) < 0) normal = vec3(0); // contacts do not pull
    vec3 friction = -kDamper * share / dt * vec3(c.slipVelocity) * 1e-6;
    float most = fragmentBlock.friction * length(normal);
    float size = length(friction);
    if (size > most) friction *= most / size;
    return normal + friction + vec3(c.impact) * 1e-3;
}

/// Angular velocity (rad/s) of a body with this inertia and angular momentum. `inverted`: of the inertia with a small
/// addition, which is finite; the second step restores the loss of the first, which would slow down a body that turns
/// for long.
vec3 angularVelocityOf(mat3 inertia, mat3 inverted, vec3 angularMomentum) {
    vec3 first = inverted * angularMomentum;
    return first + inverted * (angularMomentum - inertia * first);
}

void main() {
    uint fragment = gl_WorkGroupID.x + 1;
    uint lane = gl_LocalInvocationID.x;
    vec4 place = vec4(0); // sum of positions, number of members
    vec4 speed = vec4(0); // sum of velocities
    vec3 middle = metal.origin + 0.5 * TILE_EDGE * vec3(metal.tiles) * metal.spacing; // keeps the sums small
    for (uint entry = lane; entry < control.particles; entry += FRAGMENT_GROUP) {
        if (!isMember(entry, fragment)) continue;
        place += vec4(position[freeSlots[entry]].xyz - middle, 1);
        speed += vec4(velocity[freeSlots[entry]].xyz, 0);
    }
    place = total(place);
    speed = total(speed);
    float members = place.w;
    if (members == 0) return;
    vec3 centre = middle + place.xyz / members;
    float share = members / max(float(motion[fragment].fixedContacts), 1.0);

    // Angular momentum and torque over the particle mass; moments and products of inertia likewise.
    vec3 angularMomentum = vec3(0), force = vec3(0), torque = vec3(0), diagonal = vec3(0), mixed = vec3(0);
    for (uint entry = lane; entry < control.particles; entry += FRAGMENT_GROUP) {
        if (!isMember(entry, fragment)) continue;
        uint slot = freeSlots[entry];
        vec3 arm = position[slot].xyz - centre;
        vec3 push = contactForce(entry, share);
        angularMomentum += cross(arm, velocity[slot].xyz);
        force += push;
        torque += cross(arm, push);
        diagonal += arm.yzx * arm.yzx + arm.zxy * arm.zxy;
        mixed -= arm.xyz * arm.yzx;
    }
    angularMomentum = total(vec4(angularMomentum, 0)).xyz;
    force = total(vec4(force, 0)).xyz;
    torque = total(vec4(torque, 0)).xyz;
    diagonal = total(vec4(diagonal, 0)).xyz;
    mixed = total(vec4(mixed, 0)).xyz;
    if (lane != 0) return;
    motion[fragment].fixedContacts = 0; // reset for the next step, after all of the group have read it
    // A lone particle or a straight row has neither inertia nor angular momentum about some axis: a small share of the
    // trace makes the inverse finite.
    float little = 1e-5 * (diagonal.x + diagonal.y + diagonal.z + metal.spacing * metal.spacing);
    mat3 inertia = mat3(diagonal.x, mixed.x, mixed.z, mixed.x, diagonal.y, mixed.y, mixed.z, mixed.y, diagonal.z);
    mat3 inverted = inverse(inertia + mat3(little));
    float dt = fragmentBlock.timeStep;
    vec3 velocityNow = speed.xyz / members + dt * (metal.gravity + force / members);
    angularMomentum += dt * torque;
    vec3 angularVelocity = angularVelocityOf(inertia, inverted, angularMomentum);
    // In the rotated fragment's own frame.
    vec3 turned = rotated(angularMomentum, -angularVelocity * dt);
    vec3 atEnd = rotated(angularVelocityOf(inertia, inverted, turned), angularVelocity * dt);
    motion[fragment].centre = centre;
    motion[fragment].velocity = velocityNow;
    motion[fragment].wayShare = 1 - float(motion[fragment].heldBack) / FRAGMENT_WAY_UNIT;
    motion[fragment].heldBack = 0; // reset for the next step
    motion[fragment].angularVelocity = angularVelocity;
    motion[fragment].endAngularVelocity = atEnd;
}
