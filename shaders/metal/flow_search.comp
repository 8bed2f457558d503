#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the neighbours of moving metal, a little beyond the support, and the still metal that is among them.
#include "metal/flow_common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint substep;

/// Lists still metal that has come to lie beside the liquid, each slot once a search.
void listBoundary(uint slot) {
    if (bodies[slot].where.x == substep || atomicExchange(bodies[slot].where.x, substep) == substep) return;
    const uint entry = atomicAdd(counters.density.w, 1u);
    const uint room = fluid.room.x;
    if (entry >= room) {
        atomicAdd(counters.faults.w, 1u);
        return;
    }
    lists[2 * room + entry] = slot;
    if (entry % GROUP_SIZE != 0 && (counters.moving.w + entry) % GROUP_SIZE != 0) return; // no new group
    atomicMax(counters.boundary.x, entry / GROUP_SIZE + 1);
    atomicMax(counters.density.x, (counters.moving.w + entry) / GROUP_SIZE + 1);
}

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index >= counters.moving.w) return;
    const uint slot = lists[index];
    const vec3 place = positions[slot].xyz;
    const float reach = fluid.search.x * fluid.search.x;
    const uint base = neighbourBase(index);
    const uint parity = substep & 1u;
    const ivec3 centre = cellAt(place);
    const vec3 inside = insideCell(place, centre);
    uint found = 0;
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uint first = cell * FLOW_CELL_ROOM;
        const uint moving = cellMoving(cell, parity);
        for (uint entry = 0; entry < moving; ++entry) {
            const vec3 d = apartPacked(inside, step, sorted[first + entry].x);
            if (dot(d, d) >= reach || found >= FLOW_NEIGHBOUR_ROOM) continue;
            const uint other = sorted[first + entry].y;
            if ((other & ~FLOW_SOLID) != slot) neighbours[base + GROUP_SIZE * found++] = other;
        }
        const uint resting = cells[cell].still;
        for (uint entry = 0; entry < resting; ++entry) {
            const vec3 d = apartPacked(inside, step, still[first + entry].x);
            if (dot(d, d) >= reach || found >= FLOW_NEIGHBOUR_ROOM) continue;
            const uint other = still[first + entry].y;
            neighbours[base + GROUP_SIZE * found++] = other | FLOW_SOLID;
            listBoundary(other);
        }
    }
    if (found == FLOW_NEIGHBOUR_ROOM) atomicAdd(counters.faults.y, 1u);
    bodies[slot].where.w = found;
    velocities[slot].w = 0; // way since the search
}
