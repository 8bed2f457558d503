// Light that the workpiece blocks from the table under it, in closed form.
#ifndef MELTPOOL_RENDER_TABLE_SHADOW_GLSL
#define MELTPOOL_RENDER_TABLE_SHADOW_GLSL

#include "render/frame.glsl"

const float kContactReach = 0.007;  // m: the darkening falls by e over this distance. Chosen.
const float kContactDepth = 0.6;    // share of the room's light that is missing at the workpiece's foot. Chosen.
const float kLampPenumbra = 0.0025; // m of way through the workpiece after which no lamp light is left. Chosen.

vec3 inWorkpiece(vec3 world) {
    return transpose(mat3(frame.modelToWorld)) * (world - frame.modelToWorld[3].xyz) / (frame.modelUnit * frame.modelUnit);
}

// Share of the room's light that reaches a place beside the workpiece.
float openBesideWorkpiece(vec3 world) {
    vec3 place = inWorkpiece(world);
    float open = 1.0;
    for (int i = 0; i < frame.shadowBoxCount; ++i) {
        vec3 middle = 0.5 * (frame.shadowBoxes[i].low + frame.shadowBoxes[i].high);
        vec3 outside = max(abs(place - middle) - (frame.shadowBoxes[i].high - middle), 0.0);
        open *= 1.0 - kContactDepth * exp(-length(outside) / kContactReach);
    }
    return open;
}

// Share of the lamp's light that passes the workpiece. `toLamp`: from the surface, world.
float lampBesideWorkpiece(vec3 world, vec3 toLamp) {
    vec3 start = inWorkpiece(world), way = inWorkpiece(world + toLamp) - start;
    vec3 perWay = 1.0 / mix(way, vec3(1e-9), lessThan(abs(way), vec3(1e-9)));
    float share = 1.0;
    for (int i = 0; i < frame.shadowBoxCount; ++i) {
        vec3 toLow = (frame.shadowBoxes[i].low - start) * perWay, toHigh = (frame.shadowBoxes[i].high - start) * perWay;
        vec3 first = min(toLow, toHigh), last = max(toLow, toHigh);
        float entry = max(max(first.x, first.y), max(first.z, 0.0));
        float exit = min(min(last.x, last.y), min(last.z, 1.0));
        share *= 1.0 - smoothstep(0.0, kLampPenumbra, (exit - entry) * length(way));
    }
    return share;
}

#endif
