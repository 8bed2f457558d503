// Computes 1 / density of each particle: rho_i = sum over neighbours of m W_poly6(r_ij, h), Müller, Charypar, Gross
// 2003. Records the neighbours among the visited particles for the pass that moves them.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/neighbours.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = CLASSIC_SORTED_VELOCITIES) buffer Velocities { vec4 velocities[]; };
#ifndef ALL_PAIRS
// The moved state, already copied in order, is free for this pass's results until the next one overwrites it.
layout(std430, binding = CLASSIC_MOVED_POSITIONS) writeonly buffer Positions { uvec4 firstRows[]; };
layout(std430, binding = CLASSIC_MOVED_VELOCITIES) writeonly buffer MovedVelocities { uvec4 nextRows[]; };
layout(std430, binding = CLASSIC_CELL_SLOTS) writeonly buffer Slots { uvec2 lastRow[]; };
#endif

/// The neighbours among the first 32 particles of each row of cells, a bit each.
struct Near {
    uvec4 firstRows, nextRows;
    uint lastRow;
};

void note(int row, uint found, inout Near near) {
    near.firstRows = mix(near.firstRows, uvec4(found), equal(ivec4(row), ivec4(0, 1, 2, 3)));
    near.nextRows = mix(near.nextRows, uvec4(found), equal(ivec4(row), ivec4(4, 5, 6, 7)));
    near.lastRow = found; // the last row comes last
}

/// A little more than the support radius, squared: the other pass rounds the distance differently and may round it
/// down.
const float kMore = 1.00001;

/// True if the particle is warm or in reach of the source, so that the next pass may move it.
bool mayMove(vec3 place, float temperature) {
    const vec3 displacement = place - now.source;
    return temperature > 0.0 || dot(displacement, displacement) < kMore * now.heatRadiusSquared;
}

void main() {
    const uint i = linearInvocation();
    if (i >= now.particles) return;
    const vec4 particle = texelFetch(positionTexels, int(i));
    const vec3 place = particle.xyz;
    const ivec3 cell = cellOf(place);
    const float reach = now.supportRadius * now.supportRadius;
    float sum = 0.0;
    Near near = Near(uvec4(0), uvec4(0), 0u);
    for (int row = 0; row < kRows; ++row) {
        const uvec2 range = rangeOfRow(cell, row);
        uint found = 0u, bit = 1u; // from the 33rd particle on no bit is left
        for (uint j = range.x; j < range.y; ++j) {
            const vec3 displacement = place - texelFetch(positionTexels, int(j)).xyz;
            const float squared = dot(displacement, displacement);
            const float inside = max(reach - squared, 0.0);
            sum += inside * inside * inside;
            found |= squared < kMore * reach ? bit : 0u;
            bit <<= 1;
        }
        note(row, found, near);
    }
#ifndef ALL_PAIRS
    if (mayMove(place, particle.w)) {
        firstRows[i] = near.firstRows;
        nextRows[i] = near.nextRows;
        lastRow[i].x = near.lastRow;
    }
#endif
    velocities[i].w = 1.0 / (now.poly6 * sum);
}
