// What the passes over solid pieces have in common: the lattice, the coarse cells and who is solid.
#include "shared/dispatch.h"
#include "shared/pieces.h"
#include "metal/state.glsl"

layout(std140, binding = PIECES_BLOCK) uniform Pieces { PiecesBlock pieces; };
layout(std430, binding = METAL_COUNTERS) readonly buffer Counters { MetalCounters counters; };
layout(std430, binding = PIECES_HEADS) buffer Heads { uint head[]; };
layout(std430, binding = PIECES_NEXT) buffer Nexts { uint next[]; };
layout(std430, binding = PIECES_CONTROL) buffer Control { PiecesControl control; };

bool solid(uint bits) { return (bits & (PHASE_ALIVE | PHASE_LIQUID)) == PHASE_ALIVE; }
uint pieceOf(uint bits) { return (bits & PIECE_BITS) >> PHASE_PIECE_SHIFT; }

/// Particles outside the lattice are kept in the border cells: that only costs distance tests.
ivec3 coarseCell(vec3 place) { return clamp(latticeCell(place) >> 1, ivec3(0), pieces.coarse.xyz - 1); }

uint coarseIndex(ivec3 cell) { return uint((cell.z * pieces.coarse.y + cell.y) * pieces.coarse.x + cell.x); }
