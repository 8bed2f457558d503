// Smoke that an arc lights.
#ifndef MELTPOOL_RENDER_HAZE_GLSL
#define MELTPOOL_RENDER_HAZE_GLSL

#include "render/frame.glsl"

// m from the arc to where the smoke has thinned out. None: chosen, about the width of the plume at a hand's height.
const float kSmokeReach = 0.02;

// Light that a ray gathers between two places on it, for a scattering of 1; see core/render/effects/haze.hpp.
// `passing`: from the arc to the nearest place of the ray, `nearest`: along the ray to there; model units.
vec3 hazeLight(float passing, float nearest, float begin, float end) {
    float h = max(passing, sqrt(frame.arcMinDistanceSquared));
    // The difference of both arcs' tangents is one: between 0 and pi.
    float even = atan((end - begin) * h, h * h + (end - nearest) * (begin - nearest)) / h;
    return frame.arcLight / 12.56637 * max(even - (end - begin) / (kSmokeReach * kSmokeReach), 0.0);
}

// Distance along the ray before it meets the workpiece, in lengths of `ray`.
float wayFree(vec3 from, vec3 ray) {
    vec3 perWay = 1.0 / mix(ray, vec3(1e-9), lessThan(abs(ray), vec3(1e-9)));
    float free = 1e9;
    for (int i = 0; i < frame.shadowBoxCount; ++i) {
        vec3 toLow = (frame.shadowBoxes[i].low - from) * perWay, toHigh = (frame.shadowBoxes[i].high - from) * perWay;
        vec3 first = min(toLow, toHigh), last = max(toLow, toHigh);
        float entry = max(max(first.x, first.y), first.z), exit = min(min(last.x, last.y), last.z);
        if (entry > 0.0 && entry < exit) free = min(free, entry);
    }
    return free;
}

#endif
