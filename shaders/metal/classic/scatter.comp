// Lists the particle numbers of each cell, within a cell in counting order.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/step.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = CLASSIC_MOVED_NUMBERS) readonly buffer Numbers { uint numbers[]; };
layout(std430, binding = CLASSIC_CELL_SLOTS) readonly buffer Slots { uvec2 slots[]; };
layout(std430, binding = CLASSIC_CELL_STARTS) readonly buffer Starts { uint starts[]; };
layout(std430, binding = CLASSIC_CELL_NUMBERS) writeonly buffer CellNumbers { uint cellNumbers[]; };

void main() {
    const uint i = linearInvocation();
    if (i >= now.particles) return;
    const uvec2 slot = slots[i];
    cellNumbers[starts[slot.x] + slot.y] = numbers[i];
}
