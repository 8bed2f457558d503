// The workshop as the background.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/environment.glsl"
#include "render/tone.glsl"

layout(location = 0) in vec3 direction;
layout(location = 0) out vec4 colour;

layout(binding = SHARP_UNIT) uniform samplerCube sharpEnvironment;

void main() {
    colour = finish(decodeEnvironment(texture(sharpEnvironment, direction).rgb), 1.0);
}
