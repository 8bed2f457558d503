#version 450 core
#extension GL_GOOGLE_include_directive : require
// Compares the corners of the listed blocks with the iso level: one bit a corner, one word of bits an invocation.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;

layout(binding = SURFACE_TEXELS_DENSITY) uniform usamplerBuffer density;
layout(std430, binding = SURFACE_BIND_BLOCK_LIST) readonly buffer BlockList { uint blockList[]; };
layout(std430, binding = SURFACE_BIND_INSIDE) writeonly buffer Inside { uint inside[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

void main() {
    uint index = linearInvocation();
    if (index >= commands.blockCount * SURFACE_BLOCK_WORDS) return;
    uint block = blockList[index / SURFACE_BLOCK_WORDS] & ~SURFACE_LISTED_WITH_VERTICES;
    uint word = block * SURFACE_BLOCK_WORDS + index % SURFACE_BLOCK_WORDS;
    uint bits = 0u;
    for (uint i = 0u; i < 32u; ++i)
        bits |= uint(texelFetch(density, int(word * 32u + i)).x >= setup.isoLevel) << i;
    inside[word] = bits;
}
