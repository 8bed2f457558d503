// Counts and temperatures over the physical metal, in parts that their reader adds up in order.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
#include "shared/metal_statistics.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = METAL_STATISTICS_POSITIONS) uniform samplerBuffer positions;
layout(binding = METAL_STATISTICS_PHASES) uniform usamplerBuffer phases;
layout(std430, binding = METAL_STATISTICS) writeonly buffer Parts { MetalPart parts[]; };

uniform uint particles;
uniform vec3 low; // the space that metal may be in
uniform vec3 high;

void join(inout MetalPart sum, MetalPart part) {
    sum.sum += part.sum;
    sum.least = min(sum.least, part.least);
    sum.most = max(sum.most, part.most);
    sum.alive += part.alive;
    sum.molten += part.molten;
    sum.outside += part.outside;
    sum.broken += part.broken;
}

/// A slot's contribution. SYNCHRONOUS_DRIVER: no branch, because it computes both sides of one.
MetalPart partOf(uint slot) {
    uint bits = texelFetch(phases, int(slot)).x;
    vec4 p = texelFetch(positions, int(slot));
    bool alive = (bits & PHASE_ALIVE) != 0u;
    bool broken = any(isnan(p)) || any(isinf(p));
    bool inside = all(greaterThanEqual(p.xyz, low)) && all(lessThanEqual(p.xyz, high));
    float temperature = broken || !alive ? 0.0 : p.w;
    return MetalPart(temperature, alive ? temperature : 3.4e38, temperature, uint(alive),
                     uint(alive && (bits & PHASE_LIQUID) != 0u), uint(alive && !inside), uint(alive && broken), 0u);
}

// An invocation a part: on a CPU, adding the parts behind a barrier costs more than reading the metal.
void main() {
    uint part = gl_GlobalInvocationID.x;
    MetalPart sum = MetalPart(0.0, 3.4e38, 0.0, 0u, 0u, 0u, 0u, 0u);
    for (uint slot = part; slot < particles; slot += METAL_STATISTICS_PARTS) join(sum, partOf(slot));
    parts[part] = sum;
}
