// An after-image: a dark spot with a purple rim, the effect of strong light on the eye's cells.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/tone.glsl"

layout(location = 0) in vec2 place;
layout(location = 0) out vec4 colour;

layout(location = 6) uniform float strength; // 0..1

void main() {
    float far = dot(place, place);
    float spot = exp(-6.0 * far) - exp(-6.0);
    if (far >= 1.0) discard;
    vec3 tint = mix(vec3(0.10, 0.02, 0.14), vec3(0.01, 0.03, 0.02), smoothstep(0.5, 0.0, far)); // chosen
    colour = finishExact(tint, 0.9 * strength * min(1.6 * spot, 1.0));
}
