// A vertex of the surface in temperature colours.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/view.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position; // model units
layout(location = NORMAL_ATTRIBUTE) in vec3 outward;   // unit, model
layout(location = TEMPERATURE_ATTRIBUTE) in float vertexTemperature;

layout(location = 0) out float temperature;
layout(location = 1) out float light;
layout(location = 2) out float glint;

void main() {
    vec3 world = toWorld(position);
    vec3 n = normalize(mat3(frame.modelToWorld) * outward);
    vec3 lamp = normalize(frame.lamp - world);
    vec3 mirrored = normalize(reflect(world - frame.views[viewIndex()].eye, n));
    temperature = vertexTemperature;
    light = frame.ambient + frame.diffuse * max(dot(n, lamp), 0.0);
    glint = 0.25 * frame.specular * pow(max(dot(mirrored, lamp), 0.0), frame.shininess);
    showCut(world);
}
