// A marker: its own colour in any light, a little darker towards its outline, so that its form is visible; one that is
// more transparent where it faces the eye keeps its outline.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/tone.glsl"

layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 way;
layout(location = 0) out vec4 colour;

layout(location = 5) uniform vec3 paint;  // linear colour
layout(location = 6) uniform float cover; // 0..1
layout(location = 7) uniform float face;  // share of it where the surface faces the eye

void main() {
    float facing = abs(dot(normalize(normal), normalize(way)));
    colour = finishExact(paint * mix(0.6, 1.0, facing), cover - cover * (1.0 - face) * facing);
}
