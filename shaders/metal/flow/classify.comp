#version 450 core
#extension GL_GOOGLE_include_directive : require
// Finds the slots that became or ceased to be moving or wall metal since the last frame: puts them into the moving list
// and among the new wall metal of their cells, and lists the resulting work of compact.comp and bin.comp.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = FLOW_PHASE_CHANGES) readonly buffer PhaseChanges { uint phaseChanges[]; };

uniform uint known; // slots below this one changed only if they are listed
uniform uint slots; // handed out so far

void noteChangedCell(uint cell) {
    if (atomicExchange(cells[cell].changed, 1u) == 0) changed[atomicAdd(counters.changedCells, 1u)] = cell;
}

/// Records that a slot became or ceased to be wall, for the wall sums of the wall metal around it.
void noteWallChange(uint slot) {
    const uint entry = atomicAdd(counters.wallChanges[counters.frame & 1u], 1u);
    if (entry < FLOW_WALL_CHANGES) changed[fluid.cellCount + entry] = slot;
}

void becomeWall(uint slot) {
    const vec3 place = position[slot].xyz;
    const uint cell = cellIndex(cellAt(place));
    nextInCell[slot] = atomicExchange(cells[cell].firstNewWall, slot + 1);
    needWallPage(cell);
    particles[slot].position = place;
    particles[slot].density = 0;
    particles[slot].cell = cell;
    particles[slot].listedSince = 0;
    particles[slot].wallSumGeneration = FLOW_NO_WALL_SUMS;
    velocity[slot] = vec4(0);
    noteChangedCell(cell);
    noteWallChange(slot);
}

void ceaseToBeWall(uint slot) {
    noteChangedCell(particles[slot].cell);
    noteWallChange(slot | FLOW_NO_LONGER_WALL);
}

/// Makes a slot moving metal; former wall still has its tether to wall.
void becomeMoving(uint slot, bool wasWall) {
    if (wasWall) phase[slot] |= PHASE_TETHER_BITS;
    lists[liquidIndex(atomicAdd(counters.liquids, 1u))] = slot;
    particles[slot].cell = cellIndex(cellAt(position[slot].xyz));
}

/// Empties the moving metal's list of the cell that the slot was last in; bin.comp fills it again.
void ceaseToMove(uint slot) { cells[particles[slot].cell].moving = 0; }

void classify(uint slot) {
    const uint bits = phase[slot];
    const bool fliesOn = flows(bits) && particles[slot].group != FLOW_GROUP_WALL; // true also if it froze in flight
    const bool moves = fliesOn || (bits & (PHASE_LIQUID | PHASE_FRAGMENT_BITS)) != 0;
    const uint now = (bits & PHASE_ALIVE) == 0 ? FLOW_GROUP_NONE : moves ? FLOW_GROUP_MOVING : FLOW_GROUP_WALL;
    if (particles[slot].group == now) return;
    // A slot that is listed twice is handled once.
    const uint before = atomicExchange(particles[slot].group, now);
    if (before == now) return;
    if (before == FLOW_GROUP_WALL) ceaseToBeWall(slot);
    if (before == FLOW_GROUP_MOVING) ceaseToMove(slot);
    if (now == FLOW_GROUP_WALL) becomeWall(slot);
    if (now == FLOW_GROUP_MOVING) becomeMoving(slot, before == FLOW_GROUP_WALL);
}

void main() {
    const uint stride = gl_NumWorkGroups.x * GROUP_SIZE;
    if (gl_GlobalInvocationID.x == 0) {
        counters.compactedLiquids = 0;
        counters.compactedFragments = 0;
    }
    const uint listed = phaseChanges[0];
    const bool complete = listed <= uint(fluid.capacity);
    for (uint slot = (complete ? known : 0) + gl_GlobalInvocationID.x; slot < slots; slot += stride)
        classify(slot);
    if (!complete) return;
    for (uint entry = gl_GlobalInvocationID.x; entry < listed; entry += stride)
        classify(phaseChanges[entry + 1]);
}
