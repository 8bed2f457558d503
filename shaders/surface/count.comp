#version 450 core
#extension GL_GOOGLE_include_directive : require
// Counts the vertices and triangles of every row of the listed blocks, and removes the blocks' settled triangles.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;
#include "surface/row.glsl"

layout(std430, binding = SURFACE_BIND_ROW_SUMS) writeonly buffer RowSums { uint rowSums[]; };
layout(binding = SURFACE_TEXELS_CASES) uniform usamplerBuffer cases;
layout(std430, binding = SURFACE_BIND_RETIRED) readonly buffer Retired { uvec2 retired[]; };
layout(std430, binding = SURFACE_BIND_INDICES) writeonly buffer Indices { uint indices[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

/// The rows of a block share the work of making its settled triangles empty.
void removeSettled(uint index) {
    uvec2 range = retired[index / SURFACE_BLOCK_ROWS] * 3u;
    for (uint i = index % SURFACE_BLOCK_ROWS; i < range.y; i += SURFACE_BLOCK_ROWS)
        indices[range.x + i] = 0u;
}

void main() {
    uint index = linearInvocation();
    if (index >= commands.blockCount * SURFACE_BLOCK_ROWS) return;
    CellRow row = readRow(index);
    uint edges = crossingEdges(row), crossed = crossedCells(row), triangles = 0u;
    while (crossed != 0u) {
        int cell = findLSB(crossed);
        crossed &= crossed - 1u;
        triangles += texelFetch(cases, int(cellCase(row, cell))).x & 7u;
    }
    rowSums[index] = (row.altered ? uint(bitCount(edges)) : 0u) | triangles << 16;
    removeSettled(index);
}
