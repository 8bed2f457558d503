// Common code of the passes over solid fragments: their buffers, the coarse cells and the test for solid particles.
#include "shared/dispatch.h"
#include "shared/fragments.h"
#include "metal/state.glsl"

layout(std140, binding = FRAGMENT_BLOCK) uniform Fragments { FragmentBlock fragmentBlock; };
layout(std430, binding = METAL_COUNTERS) readonly buffer Counters { MetalCounters counters; };
layout(std430, binding = FRAGMENT_CELL_HEADS) buffer Heads { uint head[]; };
layout(std430, binding = FRAGMENT_CELL_NEXT) buffer Nexts { uint next[]; };
layout(std430, binding = FRAGMENT_CONTROL) buffer Control { FragmentControl control; };

bool isSolid(uint bits) { return (bits & (PHASE_ALIVE | PHASE_LIQUID)) == PHASE_ALIVE; }
uint fragmentOf(uint bits) { return (bits & PHASE_FRAGMENT_BITS) >> PHASE_FRAGMENT_SHIFT; }

/// The coarse cell of a place. Particles outside the lattice are in the border cells: that only costs distance tests.
ivec3 coarseCell(vec3 place) { return clamp(latticeCell(place) >> 1, ivec3(0), fragmentBlock.coarseCells - 1); }

uint coarseIndex(ivec3 cell) {
    ivec3 size = fragmentBlock.coarseCells;
    return uint((cell.z * size.y + cell.y) * size.x + cell.x);
}

uint coarseCellCount() {
    ivec3 size = fragmentBlock.coarseCells;
    return uint(size.x * size.y * size.z);
}

// Each coarse cell has two lists of solid metal off the lattice: one of fixed metal, which rests while fragments move,
// and one of free metal. Fixed here is all that belongs to no free fragment.
uint fixedList(uint cell) { return cell; }
uint freeList(uint cell) { return coarseCellCount() + cell; }

/// Puts a particle into its list. The order within a list is arbitrary: every sum over one is in integers, every choice
/// a minimum.
void link(uint slot, uint bits, vec3 place) {
    uint cell = coarseIndex(coarseCell(place));
    next[slot] = atomicExchange(head[fragmentOf(bits) == 0 ? fixedList(cell) : freeList(cell)], slot + 1);
}
