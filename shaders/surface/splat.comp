#version 450 core
#extension GL_GOOGLE_include_directive : require
// Adds every particle to the corners around it and marks the blocks whose cells it can change.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;

layout(std430, binding = SURFACE_BIND_PARTICLES) readonly buffer Particles { vec4 particles[]; };
layout(std430, binding = SURFACE_BIND_DENSITY) buffer Density { uint density[]; };
layout(std430, binding = SURFACE_BIND_TEMPERATURE) buffer Temperature { uint temperature[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_FLAGS) writeonly buffer BlockFlags { uint flags[]; };

void markBlocks(ivec3 first, ivec3 last) {
    ivec3 low = first >> 3, high = last >> 3;
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                flags[(z * setup.blocks.y + y) * setup.blocks.x + x] = 1u;
}

void main() {
    uint index = linearInvocation();
    if (index >= setup.limits.x) return;
    vec4 particle = particles[index];
    precise vec3 place = (particle.xyz - setup.origin.xyz) * (vec3(setup.cells.xyz) / setup.extent.xyz) + 1.0;
    // Also refuses what is not a number.
    if (!all(lessThan(abs(place), vec3(1e6)))) return;
    precise float share = (particle.w - setup.origin.w) / setup.extent.w;
    share = share > 0.0 ? min(share, 1.0) : 0.0;

    int reach = setup.cells.w - 1;
    ivec3 nearest = ivec3(floor(place + 0.5));
    ivec3 first = max(nearest - reach, ivec3(1)), last = min(nearest + reach, setup.cells.xyz + 1);
    if (any(greaterThan(first, last))) return;
    markBlocks(first - 1, last);

    precise float farthest = 0.8660254 + 1.7320508 * float(reach);
    precise float perCell = 1.0 / farthest;
    for (int z = first.z; z <= last.z; ++z) {
        precise float dz = place.z - float(z);
        precise float zz = dz * dz;
        for (int y = first.y; y <= last.y; ++y) {
            precise float dy = place.y - float(y);
            precise float yz = dy * dy + zz;
            int row = cornerAddress(ivec3(0, y, z));
            for (int x = first.x; x <= last.x; ++x) {
                precise float dx = place.x - float(x);
                precise float near = 1.0 - sqrt(dx * dx + yz) * perCell;
                precise float scaled = near * float(SURFACE_UNIT) + 0.5;
                if (near <= 0.0) continue;
                uint weight = uint(scaled);
                int address = row + (x >> 3) * SURFACE_BLOCK_CORNERS + (x & 7);
                atomicAdd(density[address], weight);
                if (share > 0.0) {
                    precise float heat = float(weight) * share + 0.5;
                    atomicAdd(temperature[address], uint(heat));
                }
            }
        }
    }
}
