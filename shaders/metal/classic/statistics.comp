// Statistics of chunks of particles. The reader adds the chunks in order, so that sums have equal bits in every run.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/step.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = CLASSIC_MOVED_POSITIONS) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = CLASSIC_STATISTICS) writeonly buffer Chunks { ClassicChunk chunks[]; };

shared ClassicChunk parts[GROUP_SIZE];

void add(inout ClassicChunk sum, ClassicChunk part) {
    sum.temperatureSum += part.temperatureSum;
    sum.minTemperature = min(sum.minTemperature, part.minTemperature);
    sum.maxTemperature = max(sum.maxTemperature, part.maxTemperature);
    sum.molten += part.molten;
    sum.outside += part.outside;
}

void main() {
    const uint self = gl_LocalInvocationIndex;
    const uint first = gl_WorkGroupID.x * CLASSIC_STATISTICS_CHUNK;
    ClassicChunk sum = ClassicChunk(0.0, 3.4e38, -3.4e38, 0u, 0u);
    for (uint i = first + self; i < min(first + CLASSIC_STATISTICS_CHUNK, now.particles); i += GROUP_SIZE) {
        const vec4 p = positions[i];
        const bool inside = all(lessThanEqual(abs(p.xyz), vec3(1))); // also false for positions that are not a number
        const float temperature = p.w;
        add(sum, ClassicChunk(temperature, temperature, temperature, temperature > 0.0 ? 1u : 0u, inside ? 0u : 1u));
    }
    parts[self] = sum;
    barrier();
    if (self != 0) return;
    for (uint i = 1; i < GROUP_SIZE; ++i)
        add(sum, parts[i]);
    chunks[gl_WorkGroupID.x] = sum;
}
