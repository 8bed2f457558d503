#version 450 core
#extension GL_GOOGLE_include_directive : require
// Counts the vertices and triangles of every row of the listed blocks, and empties the triangles that these blocks have
// in the base part of the mesh.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;
#include "surface/row.glsl"

layout(std430, binding = SURFACE_BIND_ROW_SUMS) writeonly buffer RowSums { uint rowSums[]; };
layout(binding = SURFACE_TEXELS_CASES) uniform usamplerBuffer cases;
layout(std430, binding = SURFACE_BIND_OBSOLETE_TRIANGLES) readonly buffer ObsoleteTriangles { uvec2 obsoleteTriangles[]; };
layout(std430, binding = SURFACE_BIND_INDICES) writeonly buffer Indices { uint indices[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

/// Makes all three corners of each obsolete triangle one vertex. The rows of a block share its triangles.
void emptyObsoleteTriangles(uint index) {
    uvec2 range = obsoleteTriangles[index / SURFACE_BLOCK_ROWS] * 3u;
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
    rowSums[index] = (row.withVertices ? uint(bitCount(edges)) : 0u) | triangles << 16;
    emptyObsoleteTriangles(index);
}
