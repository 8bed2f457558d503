// The surface grid: storage of corners and blocks, packing of corners.
#ifndef MELTPOOL_SURFACE_GRID_GLSL
#define MELTPOOL_SURFACE_GRID_GLSL

#include "shared/dispatch.h"
#include "shared/surface.h"

layout(std140, binding = SURFACE_BIND_SETUP) uniform Setup { SurfaceSetup setup; };

/// Index of a corner in the volumes; without its low 3 bits the index of its row, without its low 9 that of its block.
int cornerAddress(ivec3 corner) {
    ivec3 block = corner >> 3, inner = corner & 7;
    return ((block.z * setup.blocks.y + block.y) * setup.blocks.x + block.x) * SURFACE_BLOCK_CORNERS + inner.z * 64 +
           inner.y * 8 + inner.x;
}

SurfaceDispatch dispatchOver(uint count) {
    return SurfaceDispatch((count + SURFACE_GROUP - 1u) / SURFACE_GROUP, 1u, 1u);
}

/// Coordinates of a block among the blocks.
ivec3 blockCoordinates(int block) {
    int row = block / setup.blocks.x;
    return ivec3(block - row * setup.blocks.x, row % setup.blocks.y, row / setup.blocks.y);
}

uint packCorner(ivec3 corner) {
    uvec3 c = uvec3(corner);
    return c.x | c.y << SURFACE_COORDINATE_BITS | c.z << 2 * SURFACE_COORDINATE_BITS;
}

ivec3 unpackCorner(uint packed_) {
    const uint most = (1u << SURFACE_COORDINATE_BITS) - 1u;
    return ivec3(uvec3(packed_, packed_ >> SURFACE_COORDINATE_BITS, packed_ >> 2 * SURFACE_COORDINATE_BITS) & most);
}

#endif
