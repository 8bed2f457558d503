#version 450 core
#extension GL_GOOGLE_include_directive : require
// Counts the vertices and triangles of every row of the listed blocks.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;
#include "surface/row.glsl"

layout(std430, binding = SURFACE_BIND_ROWS) writeonly buffer Rows { uvec2 rows[]; };
layout(std430, binding = SURFACE_BIND_ROW_SUMS) writeonly buffer RowSums { uint rowSums[]; };
layout(std430, binding = SURFACE_BIND_CASES) readonly buffer Cases { uint cases[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

void main() {
    uint index = linearInvocation();
    if (index >= commands.blockCount * SURFACE_BLOCK_ROWS) return;
    CellRow row = readRow(index);
    uint edges = crossingEdges(row), crossed = crossedCells(row), triangles = 0u;
    while (crossed != 0u) {
        int cell = findLSB(crossed);
        crossed &= crossed - 1u;
        triangles += cases[cellCase(row, cell)] & 7u;
    }
    rows[cornerAddress(row.first) >> 3] = uvec2(0u, edges);
    rowSums[index] = uint(bitCount(edges)) | triangles << 16;
}
