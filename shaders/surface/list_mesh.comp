#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the edges that cross the surface and the triangles of every row, so that the passes that make vertices and
// triangles have no idle invocations.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;
#include "surface/row.glsl"

layout(std430, binding = SURFACE_BIND_ROWS) writeonly buffer Rows { uvec2 rows[]; };
layout(std430, binding = SURFACE_BIND_ROW_SUMS) readonly buffer RowSums { uint rowSums[]; };
layout(std430, binding = SURFACE_BIND_BLOCK_SUMS) readonly buffer BlockSums { uvec2 blockSums[]; };
layout(binding = SURFACE_TEXELS_CASES) uniform usamplerBuffer cases;
layout(std430, binding = SURFACE_BIND_EDGE_LIST) writeonly buffer EdgeList { uint edgeList[]; };
layout(std430, binding = SURFACE_BIND_TRIANGLE_LIST) writeonly buffer TriangleList { uvec2 triangleList[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

void listEdges(CellRow row, uint edges, uint slot) {
    uint corner = packCorner(row.first);
    while (edges != 0u && slot < setup.maxVertices) {
        uint edge = uint(findLSB(edges));
        edges &= edges - 1u;
        edgeList[slot++ - commands.firstVertex] = corner + (edge & 7u) | edge >> 3 << 3 * SURFACE_COORDINATE_BITS;
    }
}

void listTriangles(CellRow row, uint slot) {
    uint crossed = crossedCells(row), corner = packCorner(row.first);
    while (crossed != 0u) {
        int cell = findLSB(crossed);
        crossed &= crossed - 1u;
        uint entry = texelFetch(cases, int(cellCase(row, cell))).x;
        uint end = min(slot + (entry & 7u), setup.maxTriangles);
        for (uint triangle = entry >> 3; slot < end; ++triangle, ++slot)
            triangleList[slot - commands.firstTriangle] = uvec2(corner + uint(cell), triangle);
    }
}

void main() {
    uint index = linearInvocation();
    if (index >= commands.blockCount * SURFACE_BLOCK_ROWS) return;
    CellRow row = readRow(index);
    uint sums = rowSums[index];
    uvec2 first = blockSums[index / SURFACE_BLOCK_ROWS] + uvec2(sums & 65535u, sums >> 16);
    if (row.withVertices) {
        uint edges = crossingEdges(row);
        rows[cornerAddress(row.first) >> 3] = uvec2(first.x, edges);
        listEdges(row, edges, first.x);
    }
    listTriangles(row, first.y);
}
