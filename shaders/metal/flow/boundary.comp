#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the moving neighbours of still metal that the search before has found beside the liquid; sums what still metal adds
// where that is not known.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/near.glsl"
#include "metal/flow/rest.glsl"

uniform uint substep;

/// What still metal within the support adds to the gradient and density sums.
ivec4 restSums(uint slot, vec3 place) {
    const ivec3 centre = cellAt(place);
    ivec4 sum = ivec4(0);
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        uint cell;
        if (!neighbourCell(centre, step, cell)) continue;
        const uint count = countTexel(cell, 0).x;
        for (uint entry = 0; entry < count; ++entry) {
            const uint other = residentTexel(stillBase(cell) + entry);
            if (other != slot) sum += restShare(apart(place, placeTexel(other)));
        }
    }
    return sum;
}

void main() {
    const uint entry = counters.restless.y + gl_GlobalInvocationID.x;
    if (entry >= min(counters.density.w, fluid.room.x)) return;
    const uint slot = lists[2 * fluid.room.x + entry];
    const vec3 place = placeTexel(slot);
    const uint edition = counters.boundary.w;
    if (bodies[slot].where.y != edition) {
        bodies[slot].where.y = edition;
        resting[slot] = restSums(slot, place);
    }
    bool fresh;
    const uint found = listNear(slot, place, neighbourBase(counters.moving.w + entry), 0, substep & 1u, false, fresh);
    bodies[slot].motion = vec4(0, 0, 0, found);
}
