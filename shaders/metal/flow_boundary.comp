#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the moving neighbours of still metal beside the liquid; sums what still metal adds where that has changed.
#include "metal/flow_common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint substep;

/// What still metal within the support adds to the gradient and density sums, before their prefactors.
vec4 restSums(uint slot, vec3 place) {
    const float reach = fluid.origin.w * fluid.origin.w;
    const float inverse = fluid.inverseCell.w * fluid.inverseCell.w;
    const ivec3 centre = cellAt(place);
    const vec3 inside = insideCell(place, centre);
    const float nearly = fluid.search.x * fluid.search.x; // packed places are a little off
    const vec3 scale = packedScale();
    vec4 sum = vec4(0);
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uint count = countTexel(cell, 0).x;
        const vec3 origin = packedOrigin(inside, step);
        for (uint entry = 0; entry < count; ++entry) {
            const uvec2 other = residentTexel(stillBase(cell) + entry);
            const vec3 about = apartPacked(origin, other.x, scale);
            if (dot(about, about) >= nearly) continue;
            const vec3 d = apart(place, placeTexel(other.y));
            const float r2 = dot(d, d);
            if (r2 >= reach || other.y == slot) continue;
            const float u = 1 - r2 * inverse;
            sum += u * u * u * vec4(fluid.body.w * d, u);
        }
    }
    return sum;
}

void main() {
    const uint entry = gl_GlobalInvocationID.x;
    if (entry >= min(counters.density.w, fluid.room.x)) return;
    const uint index = counters.moving.w + entry;
    const uint slot = lists[2 * fluid.room.x + entry];
    const vec3 place = positions[slot].xyz;
    const uint state = counters.boundary.w;
    if (bodies[slot].where.y != state) {
        bodies[slot].where.y = state;
        resting[slot] = restSums(slot, place);
    }
    const float reach = fluid.search.x * fluid.search.x;
    const uint base = neighbourBase(index);
    const uint parity = substep & 1u;
    const ivec3 centre = cellAt(place);
    const vec3 inside = insideCell(place, centre);
    const vec3 scale = packedScale();
    uint found = 0;
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uint moving = countTexel(cell, parity).y;
        const vec3 origin = packedOrigin(inside, step);
        for (uint k = 0; k < moving; ++k) {
            const uvec2 other = residentTexel(movingBase(cell) + k);
            const vec3 d = apartPacked(origin, other.x, scale);
            if (dot(d, d) < reach && found < FLOW_NEIGHBOUR_ROOM) neighbours[base + GROUP_SIZE * found++] = other.y;
        }
    }
    bodies[slot].motion = vec4(0, 0, 0, found);
}
