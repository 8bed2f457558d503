#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the neighbours of liquid, a little beyond the support, and the solid metal among them as boundary particles;
// and the neighbours of boundary particles that were listed before.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/neighbours.glsl"

/// Lists solid metal that liquid has reached, each slot once.
void listBoundary(uint slot) {
    const uint since = counters.fullSearch;
    if (atomicExchange(particles[slot].listedSince, since) == since) return;
    const uint k = atomicAdd(counters.boundary, 1u);
    const uint row = counters.liquids + k;
    if (row >= fluid.rowCapacity) {
        atomicAdd(counters.listsOverfull, 1u);
        return;
    }
    neighbours[boundaryIndex(k)] = slot;
    const uint added = k - counters.boundaryBefore;
    if (added % GROUP_SIZE == 0) atomicMax(counters.boundaryGroups.x, added / GROUP_SIZE + 1);
    if (row % GROUP_SIZE == 0) atomicMax(counters.densityGroups.x, row / GROUP_SIZE + 1);
}

/// Lists the solid metal among the neighbours that is not listed yet. Checks for it first, so that most particles stop
/// there.
void listSolids(uint base, uint found) {
    for (uint first = 0; first < found; first += 32) {
        uint unlisted = 0;
        for (uint k = first; k < min(found, first + 32); ++k) {
            const uint neighbour = neighbours[base + GROUP_SIZE * k];
            if ((neighbour & FLOW_SOLID) != 0 && particles[neighbour & FLOW_SLOT].listedSince != counters.fullSearch)
                unlisted |= 1u << (k - first);
        }
        for (; unlisted != 0; unlisted &= unlisted - 1)
            listBoundary(neighbours[base + GROUP_SIZE * (first + uint(findLSB(unlisted)))] & FLOW_SLOT);
    }
}

bool renews(uint slot) { return particles[slot].wallSumGeneration != 0; }

/// Keeps the moving neighbours that do not renew their lists, in their order; returns their number. They list this
/// particle as long as it lists them: each pair is on both lists or on none, so that its two forces cancel.
uint keepOthers(uint base, uint found) {
    uint kept = 0;
    for (uint k = 0; k < found; ++k) {
        const uint neighbour = neighbours[base + GROUP_SIZE * k];
        if ((neighbour & FLOW_WALL) == 0 && !renews(neighbour & FLOW_SLOT))
            neighbours[base + GROUP_SIZE * kept++] = neighbour;
    }
    return kept;
}

void main() {
    if (gl_GlobalInvocationID.x >= counters.listed) return;
    const uint row = lists[compactedIndex(gl_GlobalInvocationID.x)];
    const bool liquid = row < counters.liquids;
    const uint slot = slotOf(row);
    const bool moves = liquid || particles[slot].group == FLOW_GROUP_MOVING;
    const uint base = neighbourBase(row);
    const bool all = counters.stale > FLOW_STALE_CAPACITY;
    const uint kept = moves && !all ? keepOthers(base, neighbourCount(row)) : 0;
    bool unlisted;
    const uint found = listNeighbours(slot, positionTexel(slot), base, kept, moves, moves, unlisted);
    neighbours[neighbourCountIndex(row)] = found;
    if (found == FLOW_NEIGHBOUR_CAPACITY) atomicAdd(counters.neighboursOverfull, 1u);
    if (!liquid) return;
    if (unlisted) listSolids(base, found);
    velocity[slot].w = 0; // way of neighbours since the search
}
