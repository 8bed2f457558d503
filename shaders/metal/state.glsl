// The state that every pass of the metal works on: particle buffers, and the lattice with its tiles and cells.
#include "shared/metal.h"

layout(std140, binding = METAL_BLOCK) uniform Metal { MetalBlock metal; };

layout(std430, binding = METAL_POSITION) restrict buffer Positions { vec4 position[]; };
#ifndef METAL_WITHOUT_VELOCITIES // a pass may declare few buffers
layout(std430, binding = METAL_VELOCITY) restrict buffer Velocities { vec4 velocity[]; };
#endif
layout(std430, binding = METAL_HEAT) restrict buffer Heats { vec4 heat[]; };
layout(std430, binding = METAL_PHASE) restrict buffer Phases { uint phase[]; };
layout(std430, binding = METAL_LATTICE) restrict buffer Lattice { uint latticeSlot[]; };

ivec3 tileCoordinate(int tile) {
    ivec3 size = metal.tiles;
    return ivec3(tile % size.x, tile / size.x % size.y, tile / (size.x * size.y));
}

int tileIndex(ivec3 tile) { return (tile.z * metal.tiles.y + tile.y) * metal.tiles.x + tile.x; }

ivec3 insideCoordinate(int inside) {
    return ivec3(inside & 3, (inside >> 2) & 3, inside >> 4); // TILE_EDGE is 4
}

vec3 cellCentre(ivec3 cell) { return metal.origin + (vec3(cell) + 0.5) * metal.spacing; }

ivec3 latticeCell(vec3 place) { return ivec3(floor((place - metal.origin) / metal.spacing)); }

bool inLattice(ivec3 cell) {
    return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, metal.tiles * TILE_EDGE));
}

/// Index of a cell in the lattice buffer; the cell must be inside.
uint latticeIndex(ivec3 cell) {
    ivec3 tile = cell / TILE_EDGE;
    ivec3 inside = cell - tile * TILE_EDGE;
    return uint(tileIndex(tile) * TILE_CELLS + (inside.z * TILE_EDGE + inside.y) * TILE_EDGE + inside.x);
}
