// A square about the arc that holds the ball of smoke which it lights.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/haze.glsl"

layout(location = 0) out vec3 way;        // model units, from the eye, likewise the next
layout(location = 1) flat out vec3 toArc;
layout(location = 2) flat out vec3 eye;   // model units
layout(location = 3) flat out float seen; // share of the arc that hands leave in sight

void main() {
    ViewData view = frame.views[viewIndex()];
    vec3 arc = frame.arc - view.eye; // world
    float distance_ = length(arc), reach = kSmokeReach * frame.modelUnit;
    // Seen from the eye a ball is wider than its radius; from inside, it is everywhere.
    float half_ = distance_ > 1.05 * reach ? reach * distance_ / sqrt(distance_ * distance_ - reach * reach) : 4.0 * reach;
    int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID; // 0 1 2, 3 2 1
    vec2 at = vec2(corner & 1, corner >> 1) * 2.0 - 1.0;
    vec3 towards = arc / max(distance_, 1e-6);
    vec3 up = transpose(mat3(view.worldToEye))[1];
    vec3 side = normalize(cross(towards, up)), high = cross(side, towards);
    vec3 world = arc + half_ * (side * at.x + high * at.y);
    mat3 toModel = transpose(mat3(frame.modelToWorld)) / (frame.modelUnit * frame.modelUnit);
    way = toModel * world;
    toArc = toModel * arc;
    eye = toModel * (view.eye - frame.modelToWorld[3].xyz);
    seen = view.arcSeen;
    showAt(toClip(view.eye + world));
}
