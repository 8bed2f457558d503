#version 450 core
#extension GL_GOOGLE_include_directive : require
// Finds the slots that changed between still and moving since the last frame: they enter the still cells or the moving list.
#include "metal/flow_common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint slots; // handed out so far

void markDirty(uint cell) {
    if (atomicExchange(cells[cell].wakened, FLOW_CELL_DIRTY) != FLOW_CELL_DIRTY)
        dirty[atomicAdd(counters.dirtyGroups.w, 1u)] = cell;
}

void becomeStill(uint slot) {
    const uint cell = cellIndex(cellAt(positions[slot].xyz));
    const uint entry = atomicAdd(cells[cell].still, 1u);
    if (entry < FLOW_CELL_ROOM)
        still[cell * FLOW_CELL_ROOM + entry] = slot;
    else
        atomicAdd(counters.faults.x, 1u);
    bodies[slot].where.w = cell;
    velocities[slot] = vec4(0);
    markDirty(cell);
}

void becomeMoving(uint slot) {
    const uint entry = atomicAdd(counters.sortGroups.w, 1u);
    if (entry < fluid.room.x)
        lists[entry] = slot;
    else
        atomicAdd(counters.faults.w, 1u);
    const uint cell = cellIndex(cellAt(positions[slot].xyz));
    bodies[slot].where.xy = uvec2(cell);
}

void main() {
    const uint slot = linearInvocation();
    if (slot == 0) counters.spare.x = 0;
    if (slot >= slots) return;
    const uint phase = phases[slot];
    const bool moves = (phase & PHASE_LIQUID) != 0 || (phase >> PHASE_PIECE_SHIFT) != 0;
    const uint now = (phase & PHASE_ALIVE) == 0 ? FLOW_BELONGS_NOWHERE
                     : moves                    ? FLOW_BELONGS_MOVING
                                                : FLOW_BELONGS_STILL;
    const uint before = bodies[slot].where.z;
    if (now == before) return;
    bodies[slot].where.z = now;
    if (before == FLOW_BELONGS_STILL) markDirty(bodies[slot].where.w);
    if (now == FLOW_BELONGS_STILL) becomeStill(slot);
    if (now == FLOW_BELONGS_MOVING) becomeMoving(slot);
}
