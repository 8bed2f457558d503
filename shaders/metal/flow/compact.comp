#version 450 core
#extension GL_GOOGLE_include_directive : require
// Updates the changed cells' lists of wall metal; removes metal that stopped from the moving list and separates liquid
// from fragments there; empties the cells of moving metal.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = FLOW_PHASE_CHANGES) writeonly buffer PhaseChanges { uint phaseChanges[]; };

/// Inserts a wall particle among the `kept` ones before it by slot. Few cells change, so an insertion sort is fast
/// enough.
void insertWall(uint base, uint kept, uint packedPosition, uint slot) {
    uint place = kept;
    for (; place > 0 && pages[pageSlotIndex(base + place - 1)] > slot; --place)
        writePageEntry(base + place, pages[base + place - 1], pages[pageSlotIndex(base + place - 1)]);
    writePageEntry(base + place, packedPosition, slot);
}

bool isWallOf(uint slot, uint cell) { return particles[slot].group == FLOW_GROUP_WALL && particles[slot].cell == cell; }

/// Keeps the wall particles that still belong to the cell and adds the new ones.
void compactCell(uint cell) {
    const uint base = wallBase(cells[cell].wallPage);
    const uint count = cells[cell].walls;
    uint kept = 0;
    for (uint k = 0; k < count; ++k) {
        const uint packedPosition = pages[base + k];
        const uint slot = pages[pageSlotIndex(base + k)];
        if (!isWallOf(slot, cell)) continue;
        insertWall(base, kept, packedPosition, slot);
        ++kept;
    }
    for (uint next = cells[cell].firstNewWall; next != 0; next = nextInCell[next - 1]) {
        const uint slot = next - 1;
        if (kept < FLOW_CELL_CAPACITY)
            insertWall(base, kept++, packPosition(particles[slot].position), slot);
        else
            atomicAdd(counters.cellsOverfull, 1u);
    }
    cells[cell].walls = kept;
    cells[cell].firstNewWall = 0;
    cells[cell].changed = 0;
}

void finishFrame() {
    phaseChanges[0] = 0; // all changes are handled
    const uint parity = counters.frame & 1u;
    if (counters.wallChanges[parity] > FLOW_WALL_CHANGES) counters.wallSumGeneration += 1;
    counters.wallChanges[1 - parity] = 0; // reset for the next frame
    counters.frame += 1;
    counters.movingPages = 0;
}

void compactMoving(uint slot) {
    if (particles[slot].group != FLOW_GROUP_MOVING) return;
    cells[particles[slot].cell].moving = 0;
    const uint index = flows(phase[slot])
                           ? liquidIndex(atomicAdd(counters.compactedLiquids, 1u))
                           : fragmentIndex(atomicAdd(counters.compactedFragments, 1u));
    lists[compactedIndex(index)] = slot;
}

void main() {
    const uint stride = gl_NumWorkGroups.x * GROUP_SIZE;
    if (gl_GlobalInvocationID.x == 0) finishFrame();
    const uint changedCells = counters.changedCells;
    for (uint k = gl_GlobalInvocationID.x; k < changedCells; k += stride)
        compactCell(changed[k]);
    const uint moving = counters.liquids + counters.fragments;
    for (uint k = gl_GlobalInvocationID.x; k < moving; k += stride)
        compactMoving(movingSlot(k));
}
