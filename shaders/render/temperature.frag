// The surface in temperature colours, lit so that its shape is visible; no mirror image and a faint highlight, so that the
// colour stays readable.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/scale.glsl"

layout(location = 0) in float temperature;
layout(location = 1) in float light;
layout(location = 2) in float glint;
layout(location = 0) out vec4 colour;

void main() {
    colour = finish(light * scaleColour(temperature) + glint, 1.0);
}
