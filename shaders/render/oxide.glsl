// Islands of oxide on a pool: they cover the surface near each carrier that find_oxide.comp found.
#ifndef MELTPOOL_RENDER_OXIDE_GLSL
#define MELTPOOL_RENDER_OXIDE_GLSL

#include "render/frame.glsl"

layout(std430, binding = OXIDE_BINDING) readonly buffer Oxide { OxideIslands oxide; };
layout(binding = NOISE_UNIT) uniform sampler3D oxideNoise;

// Waves of an island's outline over its radius, and their depth. None: chosen.
const float kOutlineWaves = 0.11;
const float kOutlineDepth = 0.8;

// Share of the surface at `world` under oxide. A deeper carrier covers less: its ball cuts the surface in a smaller disc. The
// outline is fixed to the carrier and goes with it.
float oxideAt(vec3 world) {
    float nearest = 4.0;
    vec3 way = vec3(0.0);
    for (uint i = 0u; i < oxide.count; ++i) {
        vec3 d = (world - oxide.islands[i].place) * oxide.islands[i].perRadius;
        float square = dot(d, d);
        if (square < nearest) {
            nearest = square;
            way = d + 7.0 * float(oxide.islands[i].carrier & 1023u);
        }
    }
    float uneven = textureLod(oxideNoise, kOutlineWaves * way, 0.0).r - 0.5;
    return 1.0 - smoothstep(0.65, 1.0, nearest + kOutlineDepth * uneven);
}

#endif
