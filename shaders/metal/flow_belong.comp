#version 450 core
#extension GL_GOOGLE_include_directive : require
// Finds the slots that changed between still and moving since the last frame: they enter the still cells or the moving list.
#include "metal/flow_common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint slots; // handed out so far

void markDirty(uint cell) {
    if (atomicExchange(cells[cell].dirty, 1u) == 0) dirty[atomicAdd(counters.spare.y, 1u)] = cell;
}

/// The cells that a slot entered last count none of it any more; all moving metal enters anew afterwards.
void leaveCells(uint slot) {
    const uvec2 entered = bodies[slot].where.xy;
    cells[entered.x].even = 0;
    cells[entered.y].odd = 0;
}

void becomeStill(uint slot) {
    const uint cell = cellIndex(cellAt(positions[slot].xyz));
    const uint entry = atomicAdd(cells[cell].still, 1u);
    if (entry < FLOW_CELL_ROOM)
        residents[stillBase(cell) + entry] = uvec2(packPlace(positions[slot].xyz), slot);
    else
        atomicAdd(counters.faults.x, 1u);
    bodies[slot].where = uvec4(0, 0, FLOW_BELONGS_STILL, cell);
    velocities[slot] = vec4(0);
    markDirty(cell);
}

void becomeMoving(uint slot) {
    const uint entry = atomicAdd(counters.moving.w, 1u);
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
    if (before == FLOW_BELONGS_STILL) markDirty(bodies[slot].where.w);
    if (before == FLOW_BELONGS_MOVING) leaveCells(slot);
    bodies[slot].where.z = now;
    if (now == FLOW_BELONGS_STILL) becomeStill(slot);
    if (now == FLOW_BELONGS_MOVING) becomeMoving(slot);
}
