#version 450 core
#extension GL_GOOGLE_include_directive : require
// Orders the moving metal of each cell by slot and lists the rows whose neighbour lists are rebuilt: the first of three
// passes that rebuild them.
// SYNCHRONOUS_DRIVER: few rows in few groups, because a group with one wanted row costs the next pass as much as one in
// which all are wanted.
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

/// Number of moving particles of a cell with a lower slot.
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

/// Puts the moving slot number k among those of its cell. `renews`: its list is rebuilt.
void sortMoving(uint k, bool renews) {
    const uint slot = movingSlot(k);
    const uint cell = particles[slot].cell;
    const uint rank = rankInCell(slot, cell);
    const uint solid = k < counters.liquids ? 0u : FLOW_SOLID;
    particles[slot].wallSumGeneration = renews ? 1 : 0;
    if (rank < FLOW_CELL_CAPACITY)
        writePageEntry(movingBase(cells[cell].movingPage) + rank, packPosition(position[slot].xyz),
                       slot | solid | (renews ? FLOW_RENEWS : 0u));
}

/// Records a row whose list is rebuilt.
void noteRow(uint row) {
    const uint k = atomicAdd(counters.listed, 1u);
    lists[compactedIndex(k)] = row;
    if (k % GROUP_SIZE == 0) atomicMax(counters.listGroups.x, k / GROUP_SIZE + 1);
}

void main() {
    const uint k = gl_GlobalInvocationID.x;
    if (k == 0) beginSearch();
    const uint liquids = counters.liquids, moving = liquids + counters.fragments;
    // If all lists are rebuilt, there are no boundary particles yet, whatever beginSearch() has done by now.
    const uint rows = min(counters.stale > FLOW_STALE_CAPACITY ? liquids : liquids + counters.boundary, fluid.rowCapacity);
    if (k >= max(moving, rows)) return;
    const bool renewsMoving = k < moving && nearStale(position[movingSlot(k)].xyz);
    if (k < moving) sortMoving(k, renewsMoving);
    if (k < rows && (k < liquids ? renewsMoving : nearStale(positionTexel(slotOf(k))))) noteRow(k);
}
