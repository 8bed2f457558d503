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

/// Lists what is near; gives the number found.
uint listNeighbours(uint slot, vec3 place, uint base) {
    const float reach = fluid.search.x * fluid.search.x;
    const uint parity = substep & 1u;
    const ivec3 centre = cellAt(place);
    const vec3 inside = insideCell(place, centre);
    const vec3 scale = packedScale();
    uint found = 0;
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uint first = movingBase(cell);
        const uvec2 counts = countTexel(cell, parity);
        const vec3 origin = packedOrigin(inside, step);
        // One loop over moving, then still metal: drivers that run on the CPU go round as often as the fullest of several
        // cells needs.
        for (uint entry = 0; entry < counts.x + counts.y; ++entry) {
            const bool rests = entry >= counts.y;
            const uvec2 other = residentTexel(first + entry + (rests ? FLOW_CELL_ROOM - counts.y : 0));
            const vec3 d = apartPacked(origin, other.x, scale);
            if (dot(d, d) < reach && (other.y & FLOW_SLOT) != slot && found < FLOW_NEIGHBOUR_ROOM)
                neighbours[base + GROUP_SIZE * found++] = other.y | (rests ? FLOW_SOLID | FLOW_RESTS : 0u);
        }
    }
    return found;
}

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index >= counters.moving.w) return;
    const uint slot = lists[index];
    const uint base = neighbourBase(index);
    const uint found = listNeighbours(slot, positions[slot].xyz, base);
    for (uint k = 0; k < found; ++k) {
        const uint entry = neighbours[base + GROUP_SIZE * k];
        if ((entry & FLOW_RESTS) != 0) listBoundary(entry & FLOW_SLOT);
    }
    if (found == FLOW_NEIGHBOUR_ROOM) atomicAdd(counters.faults.y, 1u);
    bodies[slot].where.w = found;
    velocities[slot].w = 0; // way since the search
}
