// The light of a welding arc on surfaces around it.
#ifndef MELTPOOL_RENDER_ARC_GLSL
#define MELTPOOL_RENDER_ARC_GLSL

#include "render/frame.glsl"

// Light reflected by a white diffuse surface that faces the arc: illuminance over pi. `toArc`: from the surface, world.
vec3 arcOn(vec3 toArc) {
    float squared = dot(toArc, toArc) / (frame.modelUnit * frame.modelUnit);
    return frame.arcLight / (3.14159265 * max(squared, frame.arcMinDistanceSquared));
}

// Light reflected by a white diffuse surface with unit normal `n`.
vec3 arcDiffuse(vec3 toArc, vec3 n) {
    return arcOn(toArc) * max(dot(normalize(toArc), n), 0.0);
}

// Reflection of the arc in a surface that mirrors the direction `mirrored`: Phong's lobe with this exponent, normalised
// to conserve energy.
vec3 arcMirrored(vec3 toArc, vec3 mirrored, float sharpness) {
    float towards = max(dot(normalize(mirrored), normalize(toArc)), 0.0);
    return arcOn(toArc) * 0.5 * (sharpness + 1.0) * pow(towards, sharpness);
}

#endif
