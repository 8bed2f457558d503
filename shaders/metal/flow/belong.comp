#version 450 core
#extension GL_GOOGLE_include_directive : require
// Takes up which slots changed between still and moving since the last frame: they enter the still cells or the moving list.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = FLOW_CHANGES) readonly buffer Changes { uint changes[]; };

uniform uint known; // slots below this one changed only if they are listed
uniform uint slots; // handed out so far
uniform uint frame;

void markDirty(uint cell) {
    if (atomicExchange(cells[cell].dirty, 1u) == 0) dirty[atomicAdd(counters.spare.y, 1u)] = cell;
}

/// Notes that a slot became still or ceased to be, for the sums of the still metal around it.
void noteStill(uint slot) {
    const uint entry = (frame & 1u) == 0 ? atomicAdd(counters.changes.x, 1u) : atomicAdd(counters.changes.y, 1u);
    if (entry < FLOW_STILL_CHANGES) dirty[fluid.room.y + entry] = slot;
}

/// The cells that a slot entered last count none of it any more; all moving metal enters anew afterwards.
void leaveCells(uint slot) {
    const uvec2 entered = bodies[slot].where.xy;
    cells[entered.x].even = 0;
    cells[entered.y].odd = 0;
}

void becomeStill(uint slot) {
    const uint cell = cellIndex(cellAt(position[slot].xyz));
    const uint entry = atomicAdd(cells[cell].still, 1u);
    if (entry < FLOW_CELL_ROOM)
        writeResident(stillBase(cell) + entry, packPlace(position[slot].xyz), slot);
    else
        atomicAdd(counters.faults.x, 1u);
    bodies[slot].where = uvec4(0, FLOW_NO_SUMS, FLOW_BELONGS_STILL, cell);
    bodies[slot].place = vec4(position[slot].xyz, 0);
    velocity[slot] = vec4(0);
    markDirty(cell);
    noteStill(slot);
}

void becomeMoving(uint slot) {
    const uint entry = atomicAdd(counters.moving.w, 1u);
    if (entry < fluid.room.x)
        lists[entry] = slot;
    else
        atomicAdd(counters.faults.w, 1u);
    const uint cell = cellIndex(cellAt(position[slot].xyz));
    bodies[slot].where.xy = uvec2(cell);
}

void ceaseToBeStill(uint slot) {
    markDirty(bodies[slot].where.w);
    noteStill(slot | FLOW_CEASED);
}

void lookAt(uint slot) {
    const uint bits = phase[slot];
    const bool moves = (bits & PHASE_LIQUID) != 0 || (bits >> PHASE_FRAGMENT_SHIFT) != 0;
    const uint now = (bits & PHASE_ALIVE) == 0 ? FLOW_BELONGS_NOWHERE
                     : moves                    ? FLOW_BELONGS_MOVING
                                                : FLOW_BELONGS_STILL;
    if (bodies[slot].where.z == now) return;
    // A slot that is listed twice is taken up once.
    const uint before = atomicExchange(bodies[slot].where.z, now);
    if (before == now) return;
    if (before == FLOW_BELONGS_STILL) ceaseToBeStill(slot);
    if (before == FLOW_BELONGS_MOVING) leaveCells(slot);
    if (now == FLOW_BELONGS_STILL) becomeStill(slot);
    if (now == FLOW_BELONGS_MOVING) becomeMoving(slot);
}

void main() {
    const uint stride = gl_NumWorkGroups.x * GROUP_SIZE;
    if (gl_GlobalInvocationID.x == 0) counters.spare.x = 0;
    const uint listed = changes[0];
    const bool complete = listed <= uint(fluid.cells.w);
    for (uint slot = (complete ? known : 0) + gl_GlobalInvocationID.x; slot < slots; slot += stride)
        lookAt(slot);
    if (!complete) return;
    for (uint entry = gl_GlobalInvocationID.x; entry < listed; entry += stride)
        lookAt(changes[entry + 1]);
}
