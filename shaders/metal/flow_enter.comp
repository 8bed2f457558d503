#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lets all moving metal enter the cells of the frame's first substep and sets how far the substeps' passes reach.
#include "metal/flow_common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint substep; // number of the substep that follows

void main() {
    const uint stride = gl_NumWorkGroups.x * GROUP_SIZE;
    const uint moving = counters.spare.x;
    if (gl_GlobalInvocationID.x == 0) {
        const uint groups = (moving + GROUP_SIZE - 1) / GROUP_SIZE;
        counters.moving = uvec4(groups, 1, 1, moving);
        counters.search = uvec4(groups, 1, 1, 0);
        counters.boundary.xyz = uvec3(0, 1, 1);
        counters.density = uvec4(groups, 1, 1, 0);
        counters.spare.yz = uvec2(0);
    }
    for (uint entry = gl_GlobalInvocationID.x; entry < moving; entry += stride) {
        const uint slot = lists[fluid.room.x + entry];
        lists[entry] = slot;
        enterCell(slot, positions[slot].xyz, substep & 1u);
    }
}
