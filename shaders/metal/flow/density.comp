#version 450 core
#extension GL_GOOGLE_include_directive : require
// Sweep 1: density and surface normal of liquid and boundary particles.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

void endSearch() {
    counters.boundaryGroups.x = 0;
    counters.stale = 0;
    counters.searchDue = 0;
    counters.movingPages = 0;
    counters.listed = 0;
    counters.listGroups.x = 0;
}

/// A particle's sums of gradient (xyz) and density (w) before its listed neighbours are added.
vec4 startSums(uint slot, bool isWall, float temperature) {
    if (!isWall) return vec4(0, 0, 0, 1);
    const float unit = 1 / FLOW_WALL_SUM_UNIT;
    return vec4(wallSums[slot]) * vec4(vec3(unit * wettingAt(temperature) * fluid.support), unit) + vec4(0, 0, 0, 1);
}

/// The density (Monaghan 1992) and the kernel's gradient, which is the surface normal of Akinci et al. 2013, summed with the
/// kernel (1 - q²)⁴ of flow_constants.hpp.
void sumDensity(uint row) {
    const uint slot = slotOf(row);
    const bool isWall = row >= counters.liquids && particles[slot].group == FLOW_GROUP_WALL;
    const vec4 place = position[slot];
    vec4 sum = startSums(slot, isWall, place.w);
    const uint found = neighbourCount(row);
    const float inverse = fluid.inverseSupport * fluid.inverseSupport;
    const uint base = neighbourBase(row);
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
    particles[slot].velocity = isWall ? vec3(0) : velocity[slot].xyz;
    if (row < counters.liquids) particles[slot].tether = float((phase[slot] & PHASE_TETHER_BITS) >> PHASE_TETHER_SHIFT);
}

void main() {
    const uint row = gl_GlobalInvocationID.x;
    if (row == 0) endSearch();
    // The move pass bins the moving particles again.
    if (row < counters.liquids + counters.fragments) cells[particles[movingSlot(row)].cell].moving = 0;
    if (row < max(rowCount(), counters.liquids)) sumDensity(row);
}
