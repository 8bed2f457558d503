// Joins the labels of bonded particles, among a range of slots. A label names a particle of the same fragment, no later
// than its own, so labels lead to one root; the root of connected metal in the end is its first slot, in any order of
// threads. See Playne and Hawick 2018, "A new algorithm for parallel connected-component labelling on GPUs", for
// joining by minima.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
// SYNCHRONOUS_DRIVER: gathered values are read as texels, which it fetches whole, but storage number by number.
layout(binding = FRAGMENT_TEXELS_FIRST_LABEL) uniform usamplerBuffer firstTexels;
layout(binding = FRAGMENT_TEXELS_LATTICE) uniform usamplerBuffer latticeTexels;
layout(binding = FRAGMENT_TEXELS_POSITION) uniform samplerBuffer positionTexels;
layout(std430, binding = FRAGMENT_LABELS) buffer Labels { uint label[]; };

uniform uint first; // slots,
uniform uint last;  // excluded

uint firstLabelOf(uint slot) { return texelFetch(firstTexels, int(slot)).x; }
uint latticeSlotAt(int index) { return texelFetch(latticeTexels, index).x; }

bool bonded(uint mine, uint other) {
    return ((mine | other) & PHASE_FRESH) != 0 || fragmentOf(mine) == fragmentOf(other);
}

/// The present root of a particle's label.
uint rootOf(uint slot) {
    for (uint above = label[slot]; above != slot; above = label[slot]) slot = above;
    return slot;
}

/// Joins the fragments of two particles, by their roots: most are joined already. The later root gets the earlier one
/// as its label; its own label by then, if that is not itself, belongs to the same fragment and is joined next, so that
/// no bond is lost if two threads lower one label.
void join(uint a, uint b) {
    a = rootOf(a);
    b = rootOf(b);
    while (a != b) {
        uint later = max(a, b), earlier = min(a, b);
        uint before = atomicMin(label[later], earlier);
        a = before == later ? earlier : before;
        b = earlier;
    }
}

/// Joins a particle with the metal in a neighbouring cell of the lattice. Both are always bonded: no free fragment is
/// on the lattice.
void joinWithCell(uint mine, int index) {
    uint other = latticeSlotAt(index);
    uint theirs = other != 0 ? firstLabelOf(other - 1) : FRAGMENT_NO_LABEL;
    join(mine, theirs != FRAGMENT_NO_LABEL ? theirs : mine);
}

/// Joins with the neighbours before it along each axis: those behind it join with it.
void joinOnLattice(ivec3 centre, uint mine) {
    ivec3 inner = ivec3(1, TILE_EDGE, TILE_EDGE * TILE_EDGE);
    ivec3 outer = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y) * TILE_CELLS - (TILE_EDGE - 1) * inner;
    bvec3 atEnd = equal(centre & (TILE_EDGE - 1), ivec3(0));
    // Before the lattice's first cell the particle finds itself.
    ivec3 before = ivec3(latticeIndex(centre)) - mix(inner, outer, atEnd) * ivec3(greaterThan(centre, ivec3(0)));
    joinWithCell(mine, before.x);
    joinWithCell(mine, before.y);
    joinWithCell(mine, before.z);
}

/// Advances to the next of the 27 steps from (-1, -1, -1) to (1, 1, 1).
void nextStep(inout ivec3 step) {
    ++step.x;
    if (step.x > 1) {
        step.x = -1;
        ++step.y;
    }
    if (step.y > 1) {
        step.y = -1;
        ++step.z;
    }
}

bool isBondedNeighbour(uint other, uint bits, vec3 place) {
    if (firstLabelOf(other) == FRAGMENT_NO_LABEL || !bonded(bits, phase[other])) return false;
    vec3 displacement = texelFetch(positionTexels, int(other)).xyz - place;
    float reach = FRAGMENT_BOND_LENGTH * metal.spacing;
    return dot(displacement, displacement) <= reach * reach;
}

/// Joins a particle off the lattice with those of the lattice that are bonded to it.
void joinWithLattice(ivec3 centre, uint bits, vec3 place, uint slot) {
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        ivec3 cell = centre + step;
        if (!inLattice(cell)) continue;
        uint other = latticeSlotAt(int(latticeIndex(cell)));
        if (other != 0 && isBondedNeighbour(other - 1, bits, place)) join(slot, firstLabelOf(other - 1));
    }
}

void joinWithList(uint list, uint bits, vec3 place, uint slot) {
    for (uint other = head[list]; other != 0; other = next[other - 1])
        if (isBondedNeighbour(other - 1, bits, place)) join(slot, other - 1);
}

/// Joins with those off the lattice that are bonded to it.
void joinOffLattice(ivec3 centre, uint bits, vec3 place, uint slot) {
    ivec3 low = max(centre - 1, ivec3(0));
    ivec3 high = min(centre + 1, fragmentBlock.coarseCells - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                uint cell = coarseIndex(ivec3(x, y, z));
                joinWithList(fixedList(cell), bits, place, slot);
                joinWithList(freeList(cell), bits, place, slot);
            }
}

void main() {
    uint slot = first + linearInvocation();
    if (slot >= last) return;
    uint mine = firstLabelOf(slot);
    if (mine == FRAGMENT_NO_LABEL) return;
    uint bits = phase[slot];
    vec3 place = texelFetch(positionTexels, int(slot)).xyz;
    if ((bits & PHASE_LATTICE) != 0) {
        joinOnLattice(latticeCell(place), mine);
        return;
    }
    joinWithLattice(latticeCell(place), bits, place, slot);
    joinOffLattice(coarseCell(place), bits, place, slot);
}
