// From light to what the screen shows.
#ifndef MELTPOOL_RENDER_TONE_GLSL
#define MELTPOOL_RENDER_TONE_GLSL

#include "render/frame.glsl"

const float kKnee = 0.6;

// Leaves everything below the knee as it is, so that a grey stays that grey, and bends what is brighter towards 1 with a
// continuous slope.
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

// What is written: a target that encodes takes light, a plain one takes shown values.
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

// For colours that stand for a number and must arrive as they are.
vec4 finishExact(vec3 light, float cover) {
    return encoded(light, cover);
}

#endif
