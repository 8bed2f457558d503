// 1 / density of each particle: rho_i = sum over neighbours of m W_poly6(r_ij, h), Müller, Charypar, Gross 2003.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/classic/neighbours.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = CLASSIC_SORTED_VELOCITIES) buffer Velocities { vec4 velocities[]; };

void main() {
    const uint i = linearInvocation();
    if (i >= now.particles) return;
    const vec3 place = texelFetch(positionTexels, int(i)).xyz;
    const ivec3 cell = cellOf(place);
    const float reach = now.supportRadius * now.supportRadius;
    float sum = 0.0;
    for (int row = 0; row < kRows; ++row) {
        const uvec2 range = rangeOfRow(cell, row);
        for (uint j = range.x; j < range.y; ++j) {
            const vec3 displacement = place - texelFetch(positionTexels, int(j)).xyz;
            const float inside = max(reach - dot(displacement, displacement), 0.0);
            sum += inside * inside * inside;
        }
    }
    velocities[i].w = 1.0 / (now.poly6 * sum);
}
