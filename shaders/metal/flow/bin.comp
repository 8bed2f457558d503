#version 450 core
#extension GL_GOOGLE_include_directive : require
// Puts all moving metal into cells for the frame's first substep and sets the numbers of groups of the substeps'
// passes; updates the sums of wall metal around changes of wall.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/wall_sums.glsl"

/// Adds one slot's share to the sums of the wall metal around it, or takes it away.
void updateWallSums(uint change) {
    const uint slot = change & ~FLOW_NO_LONGER_WALL;
    const vec3 place = particles[slot].position; // if it was wall; it may have begun to move
    const ivec3 centre = cellAt(place);
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uvec4 listed = readCell(cell);
        for (uint k = 0; k < listed.x; ++k) {
            const uint other = pageSlotTexel(wallBase(listed.z) + k);
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

void setCounters(uint liquids, uint fragments) {
    const uvec3 groups = uvec3((liquids + fragments + GROUP_SIZE - 1) / GROUP_SIZE, 1, 1);
    counters.movingGroups = groups;
    counters.liquids = liquids;
    counters.fragments = fragments;
    if (liquids > fluid.rowCapacity) counters.listsOverfull += liquids - fluid.rowCapacity;
    counters.searchGroups = groups;
    counters.moveGroupsDone = 0;
    counters.boundaryGroups = uvec3(0, 1, 1);
    counters.densityGroups = groups;
    counters.boundary = 0;
    counters.stale = FLOW_STALE_ALL;
    counters.boundaryBefore = 0;
    counters.fullSearch = 0;
    counters.searchDue = 0;
    counters.changedCells = 0;
    counters.listed = 0;
    counters.listGroups = uvec3(0, 1, 1);
}

void main() {
    const uint stride = gl_NumWorkGroups.x * GROUP_SIZE;
    const uint liquids = counters.compactedLiquids, fragments = counters.compactedFragments;
    if (gl_GlobalInvocationID.x == 0) setCounters(liquids, fragments);
    const uint changes = counters.wallChanges[(counters.frame - 1) & 1u]; // compact.comp has begun the next frame
    if (changes <= FLOW_WALL_CHANGES)
        for (uint k = gl_GlobalInvocationID.x; k < changes; k += stride)
            updateWallSums(changed[fluid.cellCount + k]);
    for (uint k = gl_GlobalInvocationID.x; k < liquids + fragments; k += stride) {
        const uint index = k < liquids ? liquidIndex(k) : fragmentIndex(k - liquids);
        const uint slot = lists[compactedIndex(index)];
        lists[index] = slot;
        binParticle(slot, position[slot].xyz);
    }
}
