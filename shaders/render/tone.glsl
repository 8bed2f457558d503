// From light to displayed colours.
#ifndef MELTPOOL_RENDER_TONE_GLSL
#define MELTPOOL_RENDER_TONE_GLSL

#include "render/frame.glsl"

const float kKnee = 0.6;

// Keeps light below the knee, so that a grey stays that grey, and compresses brighter light towards 1 with a continuous
// slope.
vec3 toneCurve(vec3 light) {
    vec3 over = max(light - kKnee, 0.0) / (1.0 - kKnee);
    return min(light, kKnee) + (1.0 - kKnee) * over / (1.0 + over);
}

// Fits of the sRGB curves with an error below 0.4 of 255.
vec3 toLinear(vec3 shown) {
    return shown * (shown * (shown * 0.305306011 + 0.682171111) + 0.012522878);
}

vec3 toShown(vec3 light) {
    vec3 a = sqrt(light);
    vec3 b = sqrt(a);
    vec3 c = sqrt(b);
    return clamp(0.662002687 * a + 0.684122060 * b - 0.323583601 * c - 0.0225411470 * light, 0.0, 1.0);
}

// The value to write: light for a target that encodes sRGB, displayed values for one that does not.
vec4 encoded(vec3 light, float cover) {
#ifdef ENCODE_SRGB
    return vec4(toShown(light), cover);
#else
    return vec4(light, cover);
#endif
}

// The colour to write for light that reaches the eye.
vec4 finish(vec3 light, float cover) {
    vec3 toned = toneCurve(max(light, 0.0) * frame.exposure);
    return encoded(toned, cover);
}

// Without tone curve and exposure: for colours that encode a number.
vec4 finishExact(vec3 light, float cover) {
    return encoded(light, cover);
}

#endif
