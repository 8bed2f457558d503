// The motion of each loose piece as a rigid body: momentum and spin of its particles, then gravity, contacts and friction
// over one step. One group a piece; sums in the fixed order of the loose list.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"
#include "turn.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_LOOSE) readonly buffer Loose { uint loose[]; };
layout(std430, binding = PIECES_CONTACT) readonly buffer Contacts { PieceContact contact[]; };
layout(std430, binding = PIECES_MOTION) writeonly buffer Motions { PieceMotion motion[]; };

// The spring is shared out over the contacts so that the whole piece turns around in the same few steps, whatever its size.
const float kSpring = 0.2;
const float kDamper = 0.5;

shared vec4 sums[PIECES_GROUP];

/// Sum over the group, in the order of a binary tree.
vec4 total(vec4 value) {
    uint lane = gl_LocalInvocationID.x;
    barrier();
    sums[lane] = value;
    barrier();
    for (uint reach = PIECES_GROUP / 2; reach > 0; reach /= 2) {
        if (lane < reach) sums[lane] += sums[lane + reach];
        barrier();
    }
    return sums[0];
}

bool member(uint entry, uint piece) {
    uint bits = phase[loose[entry]];
    return solid(bits) && pieceOf(bits) == piece;
}

/// Acceleration of a particle by what it touches, for its share of the piece's stiffness.
vec3 contactForce(uint entry, float share) {
    float dt = pieces.step.x;
    PieceContact c = contact[entry];
    vec3 spring = kSpring * share / (dt * dt) * vec3(c.push.xyz) * 1e-9;
    vec3 normal = spring - kDamper * share / dt * vec3(c.damp.xyz) * 1e-6;
    if (dot(normal, spring) < 0) normal = vec3(0); // contacts do not pull
    vec3 friction = -kDamper * share / dt * vec3(c.slip.xyz) * 1e-6;
    float most = pieces.step.z * length(normal);
    float size = length(friction);
    if (size > most) friction *= most / size;
    return normal + friction + vec3(c.knock.xyz) * 1e-3;
}

void main() {
    uint piece = gl_WorkGroupID.x + 1;
    uint lane = gl_LocalInvocationID.x;
    vec4 place = vec4(0);
    vec4 speed = vec4(0);
    vec3 middle = metal.origin + 0.5 * TILE_EDGE * vec3(metal.tiles) * metal.spacing; // keeps the sums small
    for (uint entry = lane; entry < control.loose; entry += PIECES_GROUP) {
        if (!member(entry, piece)) continue;
        place += vec4(position[loose[entry]].xyz - middle, 1);
        speed += vec4(velocity[loose[entry]].xyz, float(contact[entry].push.w));
    }
    place = total(place);
    speed = total(speed);
    float members = place.w;
    if (members == 0) return;
    vec3 centre = middle + place.xyz / members;
    float share = members / max(speed.w, 1.0);

    vec3 spin = vec3(0), force = vec3(0), torque = vec3(0), diagonal = vec3(0), mixed = vec3(0);
    for (uint entry = lane; entry < control.loose; entry += PIECES_GROUP) {
        if (!member(entry, piece)) continue;
        uint slot = loose[entry];
        vec3 arm = position[slot].xyz - centre;
        vec3 push = contactForce(entry, share);
        spin += cross(arm, velocity[slot].xyz);
        force += push;
        torque += cross(arm, push);
        diagonal += arm.yzx * arm.yzx + arm.zxy * arm.zxy;
        mixed -= arm.xyz * arm.yzx;
    }
    spin = total(vec4(spin, 0)).xyz;
    force = total(vec4(force, 0)).xyz;
    torque = total(vec4(torque, 0)).xyz;
    diagonal = total(vec4(diagonal, 0)).xyz;
    mixed = total(vec4(mixed, 0)).xyz;
    if (lane != 0) return;
    // A lone particle or a straight row has no inertia about some axis, and no spin about it either: a trace keeps the
    // inverse finite.
    diagonal += 1e-5 * (diagonal.x + diagonal.y + diagonal.z + metal.spacing * metal.spacing);
    mat3 inertia = mat3(diagonal.x, mixed.x, mixed.z, mixed.x, diagonal.y, mixed.y, mixed.z, mixed.y, diagonal.z);
    float dt = pieces.step.x;
    vec3 velocityNow = speed.xyz / members + dt * (metal.gravity + force / members);
    spin += dt * torque;
    vec3 turning = inverse(inertia) * spin;
    vec3 after = turned(inverse(inertia) * turned(spin, -turning * dt), turning * dt); // in the turned piece's own frame
    motion[piece] =
        PieceMotion(vec4(centre, members), vec4(velocityNow, speed.w), vec4(turning, 0), vec4(after, 0));
}
