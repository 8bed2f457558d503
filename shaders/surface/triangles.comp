#version 450 core
#extension GL_GOOGLE_include_directive : require
// Writes the vertex indices of every listed triangle.
#include "surface/grid.glsl"
layout(local_size_x = SURFACE_GROUP) in;

layout(binding = SURFACE_TEXELS_ROWS) uniform usamplerBuffer rows;
layout(binding = SURFACE_TEXELS_CASES) uniform usamplerBuffer cases;
layout(std430, binding = SURFACE_BIND_TRIANGLE_LIST) readonly buffer TriangleList { uvec2 triangleList[]; };
layout(std430, binding = SURFACE_BIND_INDICES) writeonly buffer Indices { uint indices[]; };
layout(std430, binding = SURFACE_BIND_COMMANDS) readonly buffer Commands { SurfaceCommands commands; };

/// Index of the vertex on an edge of the cell. Bits 0-2 of `edge`: the edge's corner in the cell; bits 3-4: its axis.
uint vertexOn(ivec3 cell, uint edge) {
    ivec3 corner = cell + ivec3(uvec3(edge, edge >> 1, edge >> 2) & 1u);
    uvec2 row = texelFetch(rows, cornerAddress(corner) >> 3).xy;
    uint bit = (edge >> 3 & 3u) * 8u + uint(corner.x & 7);
    return row.x + uint(bitCount(row.y & ((1u << bit) - 1u)));
}

void main() {
    uint index = linearInvocation();
    uint triangle = commands.firstTriangle + index;
    if (triangle >= min(commands.triangleCount, setup.maxTriangles)) return;
    uvec2 entry = triangleList[index];
    ivec3 cell = unpackCorner(entry.x);
    uint edges = texelFetch(cases, int(entry.y)).x;
    // The table is counter-clockwise in the grid, whose z axis is mirrored: swapping two corners corrects this in the
    // model.
    uvec3 corners = uvec3(vertexOn(cell, edges), vertexOn(cell, edges >> 10), vertexOn(cell, edges >> 5));
    // A triangle with a vertex that did not fit becomes empty.
    if (any(greaterThanEqual(corners, uvec3(setup.maxVertices)))) corners = uvec3(0u);
    indices[triangle * 3u] = corners.x;
    indices[triangle * 3u + 1u] = corners.y;
    indices[triangle * 3u + 2u] = corners.z;
}
