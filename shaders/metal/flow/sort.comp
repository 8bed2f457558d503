#version 450 core
#extension GL_GOOGLE_include_directive : require
// Orders the moving metal of each cell by slot: the first of three passes that make neighbour lists.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

void beginSearch() {
    counters.searches += 1;
    if (counters.stale > FLOW_STALE_CAPACITY) {
        counters.densityGroups = uvec3(counters.movingGroups.x, 1, 1);
        counters.boundary = 0;
        counters.fullSearch = counters.searches;
    }
    counters.boundaryBefore = counters.boundary;
    counters.boundaryGroups.x = 0;
}

/// How many moving particles of a cell have a lower slot.
uint rankInCell(uint slot, uint cell) {
    const uint count = cells[cell].moving;
    uint rank = 0;
    uint other = cells[cell].firstMoving;
    for (uint k = 0; k < count; ++k) {
        rank += other < slot ? 1u : 0u;
        other = nextInCell[other];
    }
    return rank;
}

void main() {
    const uint k = gl_GlobalInvocationID.x;
    if (k == 0) beginSearch();
    if (k >= counters.liquids + counters.fragments) return;
    const uint slot = movingSlot(k);
    const uint cell = particles[slot].cell;
    const uint rank = rankInCell(slot, cell);
    const uint solid = k < counters.liquids ? 0u : FLOW_SOLID;
    const vec3 place = position[slot].xyz;
    const bool renews = nearStale(place);
    particles[slot].wallSumGeneration = renews ? 1 : 0;
    if (rank < FLOW_CELL_CAPACITY)
        writePageEntry(movingBase(cells[cell].movingPage) + rank, packPosition(place),
                       slot | solid | (renews ? FLOW_RENEWS : 0u));
}
