// A row of 8 cells: its edges that cross the surface and the marching-cubes case of each cell.
#ifndef MELTPOOL_SURFACE_ROW_GLSL
#define MELTPOOL_SURFACE_ROW_GLSL

layout(binding = SURFACE_TEXELS_INSIDE) uniform usamplerBuffer inside;
layout(std430, binding = SURFACE_BIND_BLOCK_LIST) readonly buffer BlockList { uint blockList[]; };

/// The inside bits of the four corner rows around a row of 8 cells, 9 corners each.
struct CellRow {
    ivec3 first;       ///< the row's first corner
    bool withVertices; ///< its vertices are made as well as its triangles
    uint near, up, back, upBack; ///< at (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1)
};

/// The 8 bits of the row that `corner` starts; none outside the grid.
uint rowBits(ivec3 corner) {
    if (any(greaterThanEqual(corner >> 3, setup.blocks))) return 0u;
    int address = cornerAddress(corner);
    return texelFetch(inside, address >> 5).x >> (address & 24) & 255u;
}

uint nineBits(ivec3 corner) {
    return rowBits(corner) | (rowBits(corner + ivec3(8, 0, 0)) & 1u) << 8;
}

/// Row number `index` among those of the listed blocks.
CellRow readRow(uint index) {
    uint listed = blockList[index / SURFACE_BLOCK_ROWS];
    ivec3 block = blockCoordinates(int(listed & ~SURFACE_LISTED_WITH_VERTICES));
    CellRow row;
    row.withVertices = (listed & SURFACE_LISTED_WITH_VERTICES) != 0u;
    row.first = block * 8 + ivec3(0, index & 7u, index >> 3 & 7u);
    row.near = nineBits(row.first);
    row.up = nineBits(row.first + ivec3(0, 1, 0));
    row.back = nineBits(row.first + ivec3(0, 0, 1));
    row.upBack = nineBits(row.first + ivec3(0, 1, 1));
    return row;
}

/// Bits of the cells (or edges along x) of the row that belong to the grid and not to the layer around it.
uint gridCells(CellRow row) {
    ivec2 last = setup.cells.yz;
    if (any(lessThan(row.first.yz, ivec2(1))) || any(greaterThan(row.first.yz, last))) return 0u;
    int low = max(1 - row.first.x, 0), high = min(setup.cells.x - row.first.x, 7);
    return high < low ? 0u : (2u << high) - (1u << low);
}

/// Crossing edges of the row's corners: bits 0-7 along x, 8-15 along y, 16-23 along z.
uint crossingEdges(CellRow row) {
    uint x = (row.near ^ row.near >> 1) & 255u, y = (row.near ^ row.up) & 255u, z = (row.near ^ row.back) & 255u;
    if (setup.caps == 0) { // edges into the layer around the grid belong to the caps
        int low = 1 - row.first.x, high = setup.cells.x - row.first.x;
        if (low > 0) x &= ~1u;
        if (high < 7) x &= (2u << max(high, -1)) - 1u;
        if (row.first.y < 1 || row.first.y > setup.cells.y) y = 0u;
        if (row.first.z < 1 || row.first.z > setup.cells.z) z = 0u;
    }
    return x | y << 8 | z << 16;
}

/// Bits of the cells that the surface passes through.
uint crossedCells(CellRow row) {
    uint any_ = row.near | row.up | row.back | row.upBack, all_ = row.near & row.up & row.back & row.upBack;
    uint crossed = (any_ | any_ >> 1) & ~(all_ & all_ >> 1) & 255u;
    return setup.caps == 0 ? crossed & gridCells(row) : crossed;
}

/// The case of a cell: bit dx + 2 dy + 4 dz is set if that corner is inside.
uint cellCase(CellRow row, int cell) {
    return (row.near >> cell & 3u) | (row.up >> cell & 3u) << 2 | (row.back >> cell & 3u) << 4 |
           (row.upBack >> cell & 3u) << 6;
}

#endif
