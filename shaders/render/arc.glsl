// The light of a welding arc on surfaces around it.
#ifndef MELTPOOL_RENDER_ARC_GLSL
#define MELTPOOL_RENDER_ARC_GLSL

#include "render/frame.glsl"

// Share of the arc's light that the workpiece lets through to a surface: it falls with the length of the straight way
// to the arc inside the workpiece's blocks, so that the edge of the shadow is soft. `toArc`: from the surface, world.
float arcBesideWorkpiece(vec3 toArc) {
    mat3 toModel = transpose(mat3(frame.modelToWorld)) / (frame.modelUnit * frame.modelUnit);
    vec3 way = toModel * toArc;
    vec3 start = toModel * (frame.arc - frame.modelToWorld[3].xyz) - way;
    vec3 perWay = 1.0 / mix(way, vec3(1e-9), lessThan(abs(way), vec3(1e-9)));
    float share = 1.0;
    for (int i = 0; i < frame.shadowBoxCount; ++i) {
        vec3 toLow = (frame.shadowBoxes[i].low - start) * perWay;
        vec3 toHigh = (frame.shadowBoxes[i].high - start) * perWay;
        vec3 first = min(toLow, toHigh), last = max(toLow, toHigh);
        float entry = max(max(first.x, first.y), max(first.z, 0.0));
        float exit = min(min(last.x, last.y), min(last.z, 1.0));
        share *= 1.0 - smoothstep(0.0, frame.shadowBoxes[i].fullDepth, (exit - entry) * length(way));
    }
    return share;
}

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
