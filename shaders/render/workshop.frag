// Paints one face of the environment's cube map with several rays a texel.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/environment.glsl"
#include "render/workshop.glsl"

layout(location = 0) in vec2 place;
layout(location = 0) out vec4 colour;

layout(location = 0) uniform int face;
layout(location = 2) uniform int rays; // a uniform, so that drivers do not unroll the loop over the rays
layout(location = 1) uniform float texel; // width of a texel in `place`

void main() {
    vec3 sum = vec3(0.0);
    for (int ray = 0; ray < rays; ++ray) {
        vec2 off = vec2(0.25, 0.1) * float(2 * ray - 1) * texel;
        vec3 light = workshop(normalize(faceDirection(face, place + off)));
        sum += min(light, vec3(ENVIRONMENT_RANGE)); // limits the edge of a lamp to the stored range
    }
    colour = vec4(sum / float(rays), 1.0);
}
