#version 450 core
#extension GL_GOOGLE_include_directive : require
// Puts all moving metal into cells for the frame's first substep and sets how far the substeps' passes reach; updates the
// sums of wall metal around what became or ceased to be wall.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/wall_sums.glsl"

/// Adds one slot's share to the sums of the wall metal around it, or takes it away.
void updateWallSums(uint change) {
    const uint slot = change & ~FLOW_NO_LONGER_WALL;
    const vec3 place = particles[slot].position; // where it was wall; it may have begun to move
    const ivec3 centre = cellAt(place);
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uint count = cellCounts(cell).x;
        for (uint entry = 0; entry < count; ++entry) {
            const uint other = cellSlotTexel(cellWallBase(cell) + entry);
            if (particles[other].wallSumGeneration != counters.wallSumGeneration || other == slot) continue;
            ivec4 share = wallShare(displacement(positionTexel(other), place));
            if (share == ivec4(0)) continue;
            if ((change & FLOW_NO_LONGER_WALL) != 0) share = -share;
            atomicAdd(wallSums[other].x, share.x);
            atomicAdd(wallSums[other].y, share.y);
            atomicAdd(wallSums[other].z, share.z);
            atomicAdd(wallSums[other].w, share.w);
        }
    }
}

void setCounters(uint moving) {
    const uvec3 groups = uvec3((moving + GROUP_SIZE - 1) / GROUP_SIZE, 1, 1);
    counters.movingGroups = groups;
    counters.moving = moving;
    counters.searchGroups = groups;
    counters.moveGroupsDone = 0;
    counters.boundaryGroups = uvec3(0, 1, 1);
    counters.densityGroups = groups;
    counters.walls = 0;
    counters.stale = FLOW_STALE_ALL;
    counters.wallsBefore = 0;
    counters.fullSearch = 0;
    counters.searchDue = 0;
    counters.changedCells = 0;
}

void main() {
    const uint stride = gl_NumWorkGroups.x * GROUP_SIZE;
    const uint moving = counters.compacted;
    if (gl_GlobalInvocationID.x == 0) setCounters(moving);
    const uint changes = counters.wallChanges[(counters.frame - 1) & 1u]; // compact.comp has begun the next frame
    if (changes <= FLOW_WALL_CHANGES)
        for (uint entry = gl_GlobalInvocationID.x; entry < changes; entry += stride)
            updateWallSums(changed[fluid.cellCount + entry]);
    for (uint entry = gl_GlobalInvocationID.x; entry < moving; entry += stride) {
        const uint slot = lists[compactedIndex(entry)];
        lists[entry] = slot;
        binParticle(slot, position[slot].xyz);
    }
}
