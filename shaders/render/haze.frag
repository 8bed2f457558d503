// The smoke about the arc, in closed form along the ray: no ray marching, and equal in both eyes.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/haze.glsl"
#include "render/tone.glsl"

layout(location = 0) in vec3 way;
layout(location = 1) flat in vec3 toArc;
layout(location = 2) flat in vec3 eye;
layout(location = 3) flat in float seen;
layout(location = 0) out vec4 colour;

layout(location = 5) uniform float scattering; // share of light a metre

void main() {
    vec3 ray = normalize(way);
    float nearest = dot(toArc, ray);
    float square = dot(toArc, toArc) - nearest * nearest;
    float half_ = sqrt(max(kSmokeReach * kSmokeReach - square, 0.0));
    float begin = max(nearest - half_, 0.0), end = min(nearest + half_, wayFree(eye, ray));
    if (end <= begin) discard;
    vec3 light = seen * scattering * hazeLight(sqrt(max(square, 0.0)), nearest, begin, end);
    colour = encoded(min(light * frame.exposure, 1.0), 0.0);
}
