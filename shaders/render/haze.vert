// A square about the arc that holds the ball of smoke which it lights.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"
#include "render/haze.glsl"

layout(location = 0) out vec3 way;        // world, from the eye
layout(location = 1) flat out vec3 toArc; // world, from the eye
layout(location = 2) flat out vec3 eye;   // world

void main() {
    ViewData view = frame.views[viewIndex()];
    eye = view.eye;
    toArc = frame.arc - eye;
    float distance_ = length(toArc), reach = kSmokeReach * frame.modelUnit;
    // As seen from the eye a ball is wider than its radius; from inside of it, it is everywhere.
    float half_ = distance_ > 1.05 * reach ? reach * distance_ / sqrt(distance_ * distance_ - reach * reach) : 4.0 * reach;
    int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID; // 0 1 2, 3 2 1
    vec2 at = vec2(corner & 1, corner >> 1) * 2.0 - 1.0;
    vec3 towards = toArc / max(distance_, 1e-6);
    vec3 up = transpose(mat3(view.worldToEye))[1];
    vec3 side = normalize(cross(towards, up)), high = cross(side, towards);
    way = toArc + half_ * (side * at.x + high * at.y);
    showAt(toClip(eye + way));
}
