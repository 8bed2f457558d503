#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the neighbours of the boundary particles that the previous search found; computes the missing sums of wall
// metal among them.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/neighbours.glsl"
#include "metal/flow/wall_sums.glsl"

/// Contributions of other wall metal within the support to the gradient and density sums.
ivec4 sumWalls(uint slot, vec3 place) {
    const ivec3 centre = cellAt(place);
    ivec4 sum = ivec4(0);
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uvec4 listed = readCell(cell);
        for (uint k = 0; k < listed.x; ++k) {
            const uint other = pageSlotTexel(wallBase(listed.z) + k);
            if (other != slot) sum += wallShare(displacement(place, positionTexel(other)));
        }
    }
    return sum;
}

void updateSums(uint slot, vec3 place) {
    const uint generation = counters.wallSumGeneration;
    if (particles[slot].wallSumGeneration == generation) return;
    particles[slot].wallSumGeneration = generation;
    wallSums[slot] = sumWalls(slot, place);
}

void main() {
    const uint k = counters.boundaryBefore + gl_GlobalInvocationID.x;
    const uint row = counters.liquids + k;
    if (k >= counters.boundary || row >= fluid.rowCapacity) return;
    const uint slot = neighbours[boundaryIndex(k)];
    const vec3 place = positionTexel(slot);
    const bool isWall = particles[slot].group == FLOW_GROUP_WALL;
    if (isWall) updateSums(slot, place);
    bool unlisted;
    const uint found = listNeighbours(slot, place, neighbourBase(row), 0, !isWall, false, unlisted);
    neighbours[neighbourCountIndex(row)] = found;
}
