#version 450 core
#extension GL_GOOGLE_include_directive : require
// Orders the moving metal of each cell by slot: the first of three passes that make the neighbour lists anew.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint substep;

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index == 0) {
        if (counters.restless.x > FLOW_RESTLESS_ROOM) {
            counters.density = uvec4(counters.moving.x, 1, 1, 0);
            counters.restless.z = substep;
        }
        const uint listed = min(counters.density.w, fluid.room.x);
        counters.restless.y = listed;
        counters.boundary.x = 0;
        counters.spare.w += 1;
    }
    if (index >= counters.moving.w) return;
    const uint slot = lists[index];
    const uint parity = substep & 1u;
    const uint cell = bodies[slot].where[parity];
    const uint count = cellMoving(cell, parity);
    uint rank = 0;
    for (uint entry = 0; entry < count; ++entry)
        rank += entered[cell * FLOW_CELL_ROOM + entry] < slot ? 1u : 0u;
    const uint solid = (phase[slot] & PHASE_LIQUID) != 0 ? 0u : FLOW_SOLID;
    const vec3 place = position[slot].xyz;
    const bool renews = nearRestless(place);
    bodies[slot].motion.w = renews ? 1 : 0;
    if (rank < FLOW_CELL_ROOM)
        writeResident(movingBase(cell) + rank, packPlace(place), slot | solid | (renews ? FLOW_RENEWS : 0u));
}
