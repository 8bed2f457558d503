#version 450 core
#extension GL_GOOGLE_include_directive : require
// Sweep 1: density and surface normal of moving metal and of the wall metal beside it.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

void endSearch() {
    counters.boundaryGroups.x = 0;
    counters.stale = 0;
    counters.searchDue = 0;
}

/// What a particle's sums of gradient (xyz) and density (w) are before its listed neighbours are added.
vec4 startSums(uint slot, bool moves, float temperature) {
    if (moves) return vec4(0, 0, 0, 1);
    const float unit = 1 / FLOW_WALL_SUM_UNIT;
    return vec4(wallSums[slot]) * vec4(vec3(unit * wettingAt(temperature) * fluid.support), unit) + vec4(0, 0, 0, 1);
}

/// The density (Monaghan 1992) and the kernel's gradient, which is the surface normal of Akinci et al. 2013, summed with the
/// kernel (1 - q²)⁴ of flow_constants.hpp.
void main() {
    const uint entry = gl_GlobalInvocationID.x;
    const uint moving = counters.moving;
    if (entry == 0) endSearch();
    if (entry >= moving + min(counters.walls, fluid.listCapacity)) return;
    const bool moves = entry < moving;
    const uint slot = slotOf(entry);
    const vec4 place = position[slot];
    if (moves) cells[particles[slot].cell].moving = 0; // the move pass bins the particles again
    vec4 sum = startSums(slot, moves, place.w);
    const uint found = lists[neighbourCountIndex(entry)];
    const float inverse = fluid.inverseSupport * fluid.inverseSupport;
    const uint base = neighbourBase(entry);
    for (uint k = 0; k < found; ++k) {
        const uint neighbour = neighbourTexel(base, k);
        const vec4 other = texelFetch(positionTexels, int(neighbour & FLOW_SLOT));
        const vec3 d = displacement(place.xyz, other.xyz);
        const float u = max(1 - dot(d, d) * inverse, 0);
        sum += u * u * u * vec4(((neighbour & FLOW_SOLID) != 0 ? wettingAt(other.w) : 1.0) * d, u);
    }
    particles[slot].position = place.xyz;
    particles[slot].density = fluid.kernelSelf * sum.w;
    particles[slot].normal = -8 * fluid.kernelSelf * inverse * sum.xyz;
    particles[slot].temperature = place.w;
    if (moves) particles[slot].velocity = velocity[slot].xyz;
}
