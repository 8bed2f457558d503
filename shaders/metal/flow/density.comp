#version 450 core
#extension GL_GOOGLE_include_directive : require
// Sweep 1: density and surface gradient of moving metal and of the still metal beside it.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

uniform uint substep;

void main() {
    const uint index = gl_GlobalInvocationID.x;
    const uint moving = counters.moving.w;
    if (index == 0) {
        counters.boundary.x = 0; // it has run
        counters.restless.x = 0;
        counters.restless.w = 0;
    }
    if (index >= moving + min(counters.density.w, fluid.room.x)) return;
    const bool moves = index < moving;
    const uint slot = moves ? lists[index] : lists[2 * fluid.room.x + index - moving];
    const vec4 place = position[slot];
    vec4 sum; // xyz gradient, w density
    uint found;
    if (moves) {
        // The cell of the substep before: the pass that moves particles counts into it next.
        const uvec4 where = bodies[slot].where;
        if ((substep & 1u) == 0)
            cells[where.y].odd = 0;
        else
            cells[where.x].even = 0;
        sum = vec4(0, 0, 0, 1);
        found = where.w;
    } else {
        const float unit = 1 / FLOW_REST_UNIT;
        sum = vec4(resting[slot]) * vec4(vec3(unit * wettingAt(place.w) * fluid.origin.w), unit) + vec4(0, 0, 0, 1);
        found = uint(bodies[slot].motion.w);
    }
    const float inverse = fluid.inverseCell.w * fluid.inverseCell.w;
    const uint base = neighbourBase(index);
    for (uint k = 0; k < found; ++k) {
        const uint entry = neighbourTexel(base, k);
        const vec4 other = texelFetch(positionTexels, int(entry & FLOW_SLOT));
        const vec3 d = apart(place.xyz, other.xyz);
        const float u = max(1 - dot(d, d) * inverse, 0);
        sum += u * u * u * vec4(((entry & FLOW_SOLID) != 0 ? wettingAt(other.w) : 1.0) * d, u);
    }
    bodies[slot].place = vec4(place.xyz, fluid.kernel.x * sum.w);
    bodies[slot].normal = vec4(-8 * fluid.kernel.x * inverse * sum.xyz, place.w);
    if (moves) bodies[slot].motion.xyz = velocity[slot].xyz;
}
