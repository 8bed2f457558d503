#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the moving neighbours of wall metal that the search before has found beside moving metal; makes its wall sums where
// there are none.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/neighbours.glsl"
#include "metal/flow/wall_sums.glsl"

/// What other wall metal within the support adds to the gradient and density sums.
ivec4 sumWalls(uint slot, vec3 place) {
    const ivec3 centre = cellAt(place);
    ivec4 sum = ivec4(0);
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uint count = cellCounts(cell).x;
        for (uint entry = 0; entry < count; ++entry) {
            const uint other = cellSlotTexel(cellWallBase(cell) + entry);
            if (other != slot) sum += wallShare(displacement(place, positionTexel(other)));
        }
    }
    return sum;
}

void main() {
    const uint wall = counters.wallsBefore + gl_GlobalInvocationID.x;
    if (wall >= min(counters.walls, fluid.listCapacity)) return;
    const uint slot = lists[wallIndex(wall)];
    const vec3 place = positionTexel(slot);
    const uint generation = counters.wallSumGeneration;
    if (particles[slot].wallSumGeneration != generation) {
        particles[slot].wallSumGeneration = generation;
        wallSums[slot] = sumWalls(slot, place);
    }
    const uint entry = counters.moving + wall;
    bool unlisted;
    lists[neighbourCountIndex(entry)] = listNeighbours(slot, place, neighbourBase(entry), 0, false, unlisted);
    particles[slot].velocity = vec3(0);
}
