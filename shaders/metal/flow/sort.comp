#version 450 core
#extension GL_GOOGLE_include_directive : require
// Orders the moving metal of each cell by slot: the first of three passes that make neighbour lists.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

void beginSearch() {
    counters.searches += 1;
    if (counters.stale > FLOW_STALE_CAPACITY) {
        counters.densityGroups = uvec3(counters.movingGroups.x, 1, 1);
        counters.walls = 0;
        counters.fullSearch = counters.searches;
    }
    counters.wallsBefore = min(counters.walls, fluid.listCapacity);
    counters.boundaryGroups.x = 0;
}

void main() {
    const uint entry = gl_GlobalInvocationID.x;
    if (entry == 0) beginSearch();
    if (entry >= counters.moving) return;
    const uint slot = lists[entry];
    const uint cell = particles[slot].cell;
    const uint count = min(cells[cell].moving, FLOW_CELL_CAPACITY);
    uint rank = 0;
    for (uint k = 0; k < count; ++k)
        rank += binned[cell * FLOW_CELL_CAPACITY + k] < slot ? 1u : 0u;
    const uint solid = (phase[slot] & PHASE_LIQUID) != 0 ? 0u : FLOW_SOLID;
    const vec3 place = position[slot].xyz;
    const bool renews = nearStale(place);
    particles[slot].renews = renews ? 1 : 0;
    if (rank < FLOW_CELL_CAPACITY)
        writeCellEntry(cellMovingBase(cell) + rank, packPosition(place), slot | solid | (renews ? FLOW_RENEWS : 0u));
}
