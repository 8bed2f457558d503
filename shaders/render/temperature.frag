// The surface in temperature colours, lit so that its shape shows; no mirror image and a faint highlight, so that the
// colour stays readable.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/scale.glsl"

layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 way;
layout(location = 3) in float temperature;
layout(location = 4) in vec3 toLamp;
layout(location = 0) out vec4 colour;

void main() {
    vec3 n = normalize(normal);
    vec3 lamp = normalize(toLamp);
    float highlight = 0.25 * frame.phong.z * pow(max(dot(reflect(normalize(way), n), lamp), 0.0), frame.phong.w);
    float light = frame.phong.x + frame.phong.y * max(dot(n, lamp), 0.0);
    colour = finish(light * scaleColour(temperature) + highlight, 1.0);
}
