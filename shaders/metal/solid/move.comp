// Moves the particles of loose pieces as the rigid bodies they are: turned exactly, so that a piece keeps its shape.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"
#include "turn.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_LOOSE) readonly buffer Loose { uint loose[]; };
layout(std430, binding = PIECES_MOTION) readonly buffer Motions { PieceMotion motion[]; };

void main() {
    uint entry = linearInvocation();
    if (entry >= control.loose) return;
    uint slot = loose[entry];
    uint bits = phase[slot];
    if (!solid(bits) || pieceOf(bits) == 0) return;
    PieceMotion body = motion[pieceOf(bits)];
    float dt = pieces.step.x;
    vec3 arm = turned(position[slot].xyz - body.centre.xyz, body.spin.xyz * dt);
    position[slot].xyz = body.centre.xyz + body.velocity.xyz * dt + arm;
    velocity[slot].xyz = body.velocity.xyz + cross(body.after.xyz, arm);
}
