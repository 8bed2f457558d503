// A vertex of the surface in temperature colours.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = 0) in vec4 position; // model units; w: temperature
layout(location = 1) in vec4 outward;

layout(location = 0) out float temperature;
layout(location = 1) out float light;
layout(location = 2) out float glint;

void main() {
    vec3 world = toWorld(position.xyz);
    vec3 n = normalize(mat3(frame.modelToWorld) * outward.xyz);
    vec3 lamp = normalize(frame.light.xyz - world);
    vec3 mirrored = normalize(reflect(world - frame.views[viewIndex()].eye.xyz, n));
    temperature = position.w;
    light = frame.phong.x + frame.phong.y * max(dot(n, lamp), 0.0);
    glint = 0.25 * frame.phong.z * pow(max(dot(mirrored, lamp), 0.0), frame.phong.w);
    showCut(world);
}
