// Copies the state of each particle to its slot in cell order. Within a cell particles are sorted by number, so that
// the order, and with it every sum over neighbours, is equal in every run.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/step.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = CLASSIC_MOVED_POSITIONS) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = CLASSIC_MOVED_VELOCITIES) readonly buffer Velocities { vec4 velocities[]; };
layout(std430, binding = CLASSIC_MOVED_NUMBERS) readonly buffer Numbers { uint numbers[]; };
layout(std430, binding = CLASSIC_CELL_SLOTS) readonly buffer Slots { uvec2 slots[]; };
layout(binding = CLASSIC_START_TEXELS) uniform usamplerBuffer startTexels;
layout(std430, binding = CLASSIC_CELL_NUMBERS) readonly buffer CellNumbers { uint cellNumbers[]; };
layout(std430, binding = CLASSIC_SORTED_POSITIONS) writeonly buffer SortedPositions { vec4 sortedPositions[]; };
layout(std430, binding = CLASSIC_SORTED_VELOCITIES) writeonly buffer SortedVelocities { vec4 sortedVelocities[]; };
layout(std430, binding = CLASSIC_SORTED_NUMBERS) writeonly buffer SortedNumbers { uint sortedNumbers[]; };

void main() {
    const uint i = linearInvocation();
    if (i >= now.particles) return;
    const uint cell = slots[i].x;
    const uint number = numbers[i];
    const uint begin = texelFetch(startTexels, int(cell)).x, end = texelFetch(startTexels, int(cell) + 1).x;
    uint target = begin;
    for (uint k = begin; k < end; ++k)
        target += cellNumbers[k] < number ? 1u : 0u;
    sortedPositions[target] = positions[i];
    sortedVelocities[target] = velocities[i];
    sortedNumbers[target] = number;
}
