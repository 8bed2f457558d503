#version 450 core
#extension GL_GOOGLE_include_directive : require
// Puts changed still cells in order and takes what no longer moves out of the moving list; empties the cells of moving metal.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

/// Keeps the entries that still belong to the cell, by slot; few cells change, so the plain insertion is good enough.
void tidyCell(uint cell) {
    const uint base = stillBase(cell);
    const uint count = min(cells[cell].still, FLOW_CELL_ROOM);
    uint kept = 0;
    for (uint entry = 0; entry < count; ++entry) {
        const uint own = residents[base + entry];
        const uint slot = residents[slotEntry(base + entry)];
        if (bodies[slot].where.z != FLOW_BELONGS_STILL || bodies[slot].where.w != cell) continue;
        uint place = kept;
        for (; place > 0 && residents[slotEntry(base + place - 1)] > slot; --place)
            writeResident(base + place, residents[base + place - 1], residents[slotEntry(base + place - 1)]);
        writeResident(base + place, own, slot);
        ++kept;
    }
    cells[cell].still = kept;
    cells[cell].dirty = 0;
}

layout(std430, binding = FLOW_CHANGES) writeonly buffer Changes { uint changes[]; };

uniform uint substep; // number of the frame's first substep
uniform uint frame;

void main() {
    const uint stride = gl_NumWorkGroups.x * GROUP_SIZE;
    const uint dirtyCells = counters.spare.y;
    if (gl_GlobalInvocationID.x == 0) {
        changes[0] = 0; // taken up
        const bool even = (frame & 1u) == 0;
        if ((even ? counters.changes.x : counters.changes.y) > FLOW_STILL_CHANGES) counters.boundary.w = substep;
        if (even)
            counters.changes.y = 0;
        else
            counters.changes.x = 0;
    }
    for (uint entry = gl_GlobalInvocationID.x; entry < dirtyCells; entry += stride)
        tidyCell(dirty[entry]);
    const uint moving = min(counters.moving.w, fluid.room.x);
    for (uint entry = gl_GlobalInvocationID.x; entry < moving; entry += stride) {
        const uint slot = lists[entry];
        const uvec4 where = bodies[slot].where;
        if (where.z != FLOW_BELONGS_MOVING) continue;
        cells[where.x].even = 0;
        cells[where.y].odd = 0;
        lists[fluid.room.x + atomicAdd(counters.spare.x, 1u)] = slot;
    }
}
