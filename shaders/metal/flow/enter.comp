#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lets all moving metal enter the cells of the frame's first substep and sets how far the substeps' passes reach; adds what
// became still to the sums of the still metal around it and takes off what ceased to be.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/rest.glsl"

uniform uint substep; // number of the substep that follows
uniform uint frame;

/// Takes the change of one slot up in the sums of still metal around it.
void changeSums(uint change) {
    const uint slot = change & ~FLOW_CEASED;
    const vec3 place = bodies[slot].place.xyz; // it may have begun to move
    const ivec3 centre = cellAt(place);
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uint count = countTexel(cell, 0).x;
        for (uint entry = 0; entry < count; ++entry) {
            const uint other = residentTexel(stillBase(cell) + entry);
            if (bodies[other].where.y != counters.boundary.w || other == slot) continue;
            ivec4 share = restShare(apart(placeTexel(other), place));
            if (share == ivec4(0)) continue;
            if ((change & FLOW_CEASED) != 0) share = -share;
            atomicAdd(resting[other].x, share.x);
            atomicAdd(resting[other].y, share.y);
            atomicAdd(resting[other].z, share.z);
            atomicAdd(resting[other].w, share.w);
        }
    }
}

void main() {
    const uint stride = gl_NumWorkGroups.x * GROUP_SIZE;
    const uint moving = counters.spare.x;
    if (gl_GlobalInvocationID.x == 0) {
        const uint groups = (moving + GROUP_SIZE - 1) / GROUP_SIZE;
        counters.moving = uvec4(groups, 1, 1, moving);
        counters.search = uvec4(groups, 1, 1, 0);
        counters.boundary.xyz = uvec3(0, 1, 1);
        counters.density = uvec4(groups, 1, 1, 0);
        counters.restless = uvec4(FLOW_RESTLESS_ALL, 0, 0, 0);
        counters.spare.y = 0;
    }
    const uint changed = (frame & 1u) == 0 ? counters.changes.x : counters.changes.y;
    if (changed <= FLOW_STILL_CHANGES)
        for (uint entry = gl_GlobalInvocationID.x; entry < changed; entry += stride)
            changeSums(dirty[fluid.room.y + entry]);
    for (uint entry = gl_GlobalInvocationID.x; entry < moving; entry += stride) {
        const uint slot = lists[fluid.room.x + entry];
        lists[entry] = slot;
        enterCell(slot, position[slot].xyz, substep & 1u);
    }
}
