#version 450 core
#extension GL_GOOGLE_include_directive : require
// Compares the corners of the listed blocks with the iso level: one bit each, one word an invocation.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;

layout(binding = SURFACE_TEXELS_DENSITY) uniform usamplerBuffer density;
layout(std430, binding = SURFACE_BIND_BLOCK_LIST) readonly buffer BlockList { uint blockList[]; };
layout(std430, binding = SURFACE_BIND_INSIDE) writeonly buffer Inside { uint inside[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

void main() {
    uint index = linearInvocation();
    if (index >= commands.blockCount * SURFACE_BLOCK_WORDS) return;
    uint word = (blockList[index / SURFACE_BLOCK_WORDS] & ~SURFACE_LISTED_ALTERED) * SURFACE_BLOCK_WORDS + index % SURFACE_BLOCK_WORDS;
    uint bits = 0u;
    for (uint i = 0u; i < 32u; ++i)
        bits |= uint(texelFetch(density, int(word * 32u + i)).x >= setup.limits.y) << i;
    inside[word] = bits;
}
