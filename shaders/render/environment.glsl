// Reading and writing the environment's cube maps.
#ifndef MELTPOOL_RENDER_ENVIRONMENT_GLSL
#define MELTPOOL_RENDER_ENVIRONMENT_GLSL

#include "shared/render.h"

// Direction of a position -1..1 on a face of a cube map, in OpenGL's layout of faces.
vec3 faceDirection(int face, vec2 place) {
    float s = place.x;
    float t = place.y;
    if (face == 0) return vec3(1.0, -t, -s);
    if (face == 1) return vec3(-1.0, -t, s);
    if (face == 2) return vec3(s, 1.0, t);
    if (face == 3) return vec3(s, -1.0, -t);
    if (face == 4) return vec3(s, -t, 1.0);
    return vec3(-s, -t, -1.0);
}

vec3 decodeEnvironment(vec3 stored) {
    return stored * stored * ENVIRONMENT_RANGE;
}

// Adds ordered noise of up to half a step, so that gradients show no bands.
vec3 encodeEnvironment(vec3 light, vec2 pixel) {
    float noise = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
    return sqrt(clamp(light / ENVIRONMENT_RANGE, 0.0, 1.0)) + (noise - 0.5) / 1023.0;
}

#endif
