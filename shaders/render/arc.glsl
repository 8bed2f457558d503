// The light of a welding arc on the things around it.
#ifndef MELTPOOL_RENDER_ARC_GLSL
#define MELTPOOL_RENDER_ARC_GLSL

#include "render/frame.glsl"

// Light on a surface that faces the arc, over pi: what a white one there shines with. `toArc`: from the place, world.
vec3 arcOn(vec3 toArc) {
    float squared = dot(toArc, toArc) / (frame.modelUnit * frame.modelUnit);
    return frame.arcLight / (3.14159265 * max(squared, frame.arcMinDistanceSquared));
}

// What a dull white surface with unit normal `n` shines with.
vec3 arcDiffuse(vec3 toArc, vec3 n) {
    return arcOn(toArc) * max(dot(normalize(toArc), n), 0.0);
}

// The arc's image in a surface that mirrors `mirrored`: Phong's lobe of this sharpness, normalised to keep the light.
vec3 arcMirrored(vec3 toArc, vec3 mirrored, float sharpness) {
    float towards = max(dot(normalize(mirrored), normalize(toArc)), 0.0);
    return arcOn(toArc) * 0.5 * (sharpness + 1.0) * pow(towards, sharpness);
}

#endif
