// What the passes over solid pieces have in common: the lattice, the coarse cells and who is solid.
#include "shared/dispatch.h"
#include "shared/pieces.h"

layout(std140, binding = METAL_BLOCK) uniform Metal { MetalBlock metal; };
layout(std140, binding = PIECES_BLOCK) uniform Pieces { PiecesBlock pieces; };
layout(std430, binding = METAL_POSITION) buffer Positions { vec4 position[]; };
layout(std430, binding = METAL_PHASE) buffer Phases { uint phase[]; };
layout(std430, binding = METAL_LATTICE) buffer Lattice { uint latticeSlot[]; };
layout(std430, binding = METAL_COUNTERS) readonly buffer Counters { MetalCounters counters; };
layout(std430, binding = PIECES_HEADS) buffer Heads { uint head[]; };
layout(std430, binding = PIECES_NEXT) buffer Nexts { uint next[]; };
layout(std430, binding = PIECES_CONTROL) buffer Control { PiecesControl control; };

bool solid(uint bits) { return (bits & (PHASE_ALIVE | PHASE_LIQUID)) == PHASE_ALIVE; }
uint pieceOf(uint bits) { return (bits & PIECE_BITS) >> PHASE_PIECE_SHIFT; }

ivec3 latticeCell(vec3 place) { return ivec3(floor((place - metal.origin.xyz) / metal.origin.w)); }

bool inLattice(ivec3 cell) {
    return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, metal.tiles.xyz * TILE_EDGE));
}

uint latticeIndex(ivec3 cell) {
    ivec3 tile = cell / TILE_EDGE;
    ivec3 inside = cell - tile * TILE_EDGE;
    return uint(((tile.z * metal.tiles.y + tile.y) * metal.tiles.x + tile.x) * TILE_CELLS +
                (inside.z * TILE_EDGE + inside.y) * TILE_EDGE + inside.x);
}

/// Particles outside the lattice are kept in the border cells: that only costs distance tests.
ivec3 coarseCell(vec3 place) { return clamp(latticeCell(place) >> 1, ivec3(0), pieces.coarse.xyz - 1); }

uint coarseIndex(ivec3 cell) { return uint((cell.z * pieces.coarse.y + cell.y) * pieces.coarse.x + cell.x); }
