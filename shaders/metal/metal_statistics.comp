// Counts and temperatures over the physical metal, in parts that are added up in order where they are read.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
#include "shared/metal_statistics.h"

layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = METAL_POSITION) readonly buffer Positions { vec4 position[]; };
layout(std430, binding = METAL_PHASE) readonly buffer Phases { uint phase[]; };
layout(std430, binding = METAL_COUNTERS) readonly buffer Counters { MetalCounters counters; };
layout(std430, binding = METAL_STATISTICS) writeonly buffer Parts { MetalPart parts[]; };

uniform vec3 low;  // the space that metal may be in
uniform vec3 high;

shared MetalPart shares[GROUP_SIZE];

void join(inout MetalPart sum, MetalPart part) {
    sum.sum += part.sum;
    sum.least = min(sum.least, part.least);
    sum.most = max(sum.most, part.most);
    sum.alive += part.alive;
    sum.molten += part.molten;
    sum.outside += part.outside;
    sum.broken += part.broken;
}

void main() {
    uint lane = gl_LocalInvocationIndex;
    uint share = (counters.particles + METAL_STATISTICS_PARTS - 1) / METAL_STATISTICS_PARTS;
    uint first = gl_WorkGroupID.x * share;
    MetalPart sum = MetalPart(0.0, 3.4e38, 0.0, 0, 0, 0, 0, 0);
    for (uint slot = first + lane; slot < min(first + share, counters.particles); slot += GROUP_SIZE) {
        uint bits = phase[slot];
        if ((bits & PHASE_ALIVE) == 0) continue;
        vec4 p = position[slot];
        bool broken = any(isnan(p)) || any(isinf(p));
        bool inside = all(greaterThanEqual(p.xyz, low)) && all(lessThanEqual(p.xyz, high));
        float temperature = broken ? 0.0 : p.w;
        join(sum, MetalPart(temperature, temperature, temperature, 1, (bits & PHASE_LIQUID) != 0 ? 1 : 0,
                            inside ? 0 : 1, broken ? 1 : 0, 0));
    }
    shares[lane] = sum;
    barrier();
    if (lane != 0) return;
    for (uint i = 1; i < GROUP_SIZE; ++i) join(sum, shares[i]);
    parts[gl_WorkGroupID.x] = sum;
}
