#version 450 core
#extension GL_GOOGLE_include_directive : require
// Takes what ceased to be wall out of the cells' lists and what ceased to move out of the moving list; orders the lists of
// the changed cells by slot; empties the cells of moving metal.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = FLOW_PHASE_CHANGES) writeonly buffer PhaseChanges { uint phaseChanges[]; };

/// Keeps the wall particles that still belong to the cell. Few cells change, so an insertion sort is fast enough.
void compactCell(uint cell) {
    const uint base = cellWallBase(cell);
    const uint count = min(cells[cell].walls, FLOW_CELL_CAPACITY);
    uint kept = 0;
    for (uint entry = 0; entry < count; ++entry) {
        const uint packedPosition = cellLists[base + entry];
        const uint slot = cellLists[cellSlotIndex(base + entry)];
        if (particles[slot].group != FLOW_GROUP_WALL || particles[slot].cell != cell) continue;
        uint place = kept;
        for (; place > 0 && cellLists[cellSlotIndex(base + place - 1)] > slot; --place)
            writeCellEntry(base + place, cellLists[base + place - 1], cellLists[cellSlotIndex(base + place - 1)]);
        writeCellEntry(base + place, packedPosition, slot);
        ++kept;
    }
    cells[cell].walls = kept;
    cells[cell].changed = 0;
}

void finishFrame() {
    phaseChanges[0] = 0; // all are dealt with
    const uint parity = counters.frame & 1u;
    if (counters.wallChanges[parity] > FLOW_WALL_CHANGES) counters.wallSumGeneration += 1;
    counters.wallChanges[1 - parity] = 0; // for the next frame
    counters.frame += 1;
}

void main() {
    const uint stride = gl_NumWorkGroups.x * GROUP_SIZE;
    if (gl_GlobalInvocationID.x == 0) finishFrame();
    const uint changedCells = counters.changedCells;
    for (uint entry = gl_GlobalInvocationID.x; entry < changedCells; entry += stride)
        compactCell(changed[entry]);
    const uint moving = min(counters.moving, fluid.listCapacity);
    for (uint entry = gl_GlobalInvocationID.x; entry < moving; entry += stride) {
        const uint slot = lists[entry];
        if (particles[slot].group != FLOW_GROUP_MOVING) continue;
        cells[particles[slot].cell].moving = 0;
        lists[compactedIndex(atomicAdd(counters.compacted, 1u))] = slot;
    }
}
