#version 450 core
#extension GL_GOOGLE_include_directive : require
// Sweep 1: finds the neighbours of moving metal and of the still metal beside it, their density and surface gradient.
#include "metal/flow_common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint substep;

/// Writes the neighbours of `slot` and gives their number. Still metal counts only if there is moving metal near it.
uint findNeighbours(uint index, uint slot, vec3 place, bool moves) {
    const float reach = fluid.origin.w * fluid.origin.w;
    const uint base = neighbourBase(index);
    const uint parity = substep & 1u;
    const ivec3 centre = cellAt(place);
    uint found = 0;
    for (int step = 0; step < 27; ++step) {
        uint cell;
        if (!neighbourCell(centre, ivec3(step % 3, step / 3 % 3, step / 9) - 1, cell)) continue;
        const uint moving = cellMoving(cell, parity);
        for (uint entry = 0; entry < moving; ++entry) {
            const uvec4 other = sorted[cell * FLOW_CELL_ROOM + entry];
            const vec3 d = apart(place, uintBitsToFloat(other.xyz));
            if (dot(d, d) < reach && (other.w & ~FLOW_SOLID) != slot && found < FLOW_NEIGHBOUR_ROOM)
                neighbours[base + GROUP_SIZE * found++] = other.w;
        }
    }
    if (!moves && found == 0) return 0;
    for (int step = 0; step < 27; ++step) {
        uint cell;
        if (!neighbourCell(centre, ivec3(step % 3, step / 3 % 3, step / 9) - 1, cell)) continue;
        const uint resting = cells[cell].still;
        for (uint entry = 0; entry < resting; ++entry) {
            const uint other = still[cell * FLOW_CELL_ROOM + entry];
            const vec3 d = apart(place, positions[other].xyz);
            if (dot(d, d) < reach && other != slot && found < FLOW_NEIGHBOUR_ROOM)
                neighbours[base + GROUP_SIZE * found++] = other | FLOW_SOLID;
        }
    }
    if (found == FLOW_NEIGHBOUR_ROOM) atomicAdd(counters.faults.y, 1u);
    return found;
}

void main() {
    const uint index = gl_GlobalInvocationID.x;
    const uint moving = counters.sortGroups.w;
    const uint parity = substep & 1u;
    if (index >= moving + min(counters.densityGroups.w, fluid.room.x)) return;
    const bool moves = index < moving;
    const uint slot = moves ? lists[index] : lists[2 * fluid.room.x + index - moving];
    if (moves) { // the cell of the substep before: the pass that moves particles counts into it next
        const uint before = bodies[slot].where[1u - parity];
        if (parity == 0)
            cells[before].odd = 0;
        else
            cells[before].even = 0;
    }
    const vec4 place = positions[slot];
    const uint found = findNeighbours(index, slot, place.xyz, moves);
    if (found == 0 && !moves) return;

    const float inverse = fluid.inverseCell.w * fluid.inverseCell.w;
    const uint base = neighbourBase(index);
    float sum = 1;
    vec3 gradient = vec3(0);
    for (uint k = 0; k < found; ++k) {
        const uint entry = neighbours[base + GROUP_SIZE * k];
        const vec3 d = apart(place.xyz, positions[entry & ~FLOW_SOLID].xyz);
        const float u = max(1 - dot(d, d) * inverse, 0);
        const float u3 = u * u * u;
        sum += u3 * u;
        gradient += ((entry & FLOW_SOLID) != 0 ? fluid.body.w : 1.0) * u3 * d;
    }
    bodies[slot].place = vec4(place.xyz, fluid.kernel.x * sum);
    bodies[slot].normal = vec4(-8 * fluid.kernel.x * inverse * gradient, place.w);
    bodies[slot].motion = vec4(velocities[slot].xyz, found);
}
