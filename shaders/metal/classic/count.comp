// Counts the particles of each cell and stores for each particle its cell and the number counted there before it.
// Needed only after a reset or a change of the grid: in other steps the pass that moves the particles counts them.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/step.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = CLASSIC_MOVED_POSITIONS) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = CLASSIC_CELL_SLOTS) writeonly buffer Slots { uvec2 slots[]; };
layout(std430, binding = CLASSIC_CELL_COUNTS) buffer Counts { uint counts[]; };

void main() {
    const uint i = linearInvocation();
    if (i >= now.particles) return;
    const uint cell = cellIndex(cellOf(positions[i].xyz));
    slots[i] = uvec2(cell, atomicAdd(counts[cell], 1u));
}
