// The ripples of frozen metal: height = rippleHeight x wave(frequency x time at which it froze). The time changes
// smoothly along a weld, so that ripples finer than a particle are correct, and a stop of the torch leaves its mark by
// itself.
#ifndef MELTPOOL_RENDER_RIPPLES_GLSL
#define MELTPOOL_RENDER_RIPPLES_GLSL

#include "render/frame.glsl"

// Second harmonic of the wave over the first: newer metal overlaps older like scales, whose edges are steeper than
// their backs. None: chosen.
const float kRippleSkew = 0.35;
// Steepest slope of a ripple's first harmonic: finer ripples are lower. None: chosen, 0.16 is 9 degrees.
const float kRippleSteepest = 0.16;

// Slope of the wave sin(2 pi c) + skew sin(4 pi c) for each cycle c, over 2 pi.
float waveSlope(float cycles) {
    float first = cos(6.2831853 * cycles);
    return first + 2.0 * kRippleSkew * (2.0 * first * first - 1.0);
}

// Slope of the ripples' first harmonic where it is steepest, from the gradient of the freezing time; both along the same axes,
// s and model units.
vec3 rippleSlopeOf(vec3 timeSlope) {
    vec3 slope = 6.2831853 * material.rippleHeight * material.rippleFrequency * timeSlope;
    return slope * min(kRippleSteepest * inversesqrt(max(dot(slope, slope), 1e-12)), 1.0);
}

// Share of the ripples that pixels can show: none where a pitch is below 3 pixels, all from 6 on.
float rippleSeen(vec2 cyclesPerPixel) {
    return clamp(2.0 - 6.0 * length(cyclesPerPixel), 0.0, 1.0);
}

// The unit normal of a surface with normal `n` after adding a height whose gradient is `slope` (Mikkelsen 2010, "Bump
// mapping unparametrized surfaces on the GPU").
vec3 bentNormal(vec3 n, vec3 slope) {
    return normalize(n - (slope - n * dot(n, slope)));
}

#endif
