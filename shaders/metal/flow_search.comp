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
    uint found = 0;
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const FlowCell own = cells[cell];
        const uint moving = min(parity == 0 ? own.even : own.odd, FLOW_CELL_ROOM);
        for (uint entry = 0; entry < moving; ++entry) {
            const uvec4 other = sorted[cell * FLOW_CELL_ROOM + entry];
            const vec3 d = apart(place, uintBitsToFloat(other.xyz));
            if (dot(d, d) < reach && (other.w & ~FLOW_SOLID) != slot && found < FLOW_NEIGHBOUR_ROOM)
                neighbours[base + GROUP_SIZE * found++] = other.w;
        }
        for (uint entry = 0; entry < own.still; ++entry) {
            const uint other = still[cell * FLOW_CELL_ROOM + entry];
            const vec3 d = apart(place, positions[other].xyz);
            if (dot(d, d) >= reach || found >= FLOW_NEIGHBOUR_ROOM) continue;
            neighbours[base + GROUP_SIZE * found++] = other | FLOW_SOLID;
            listBoundary(other);
        }
    }
    if (found == FLOW_NEIGHBOUR_ROOM) atomicAdd(counters.faults.y, 1u);
    bodies[slot].where.w = found;
    velocities[slot].w = 0; // way since the search
}
