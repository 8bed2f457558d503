// One round of labelling connected fragments: each solid particle, and the root it knew, take the smallest label among the
// particles bonded to it. Reads the old labels only and takes minima, so the result does not depend on the order of threads.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
// What is gathered is read as texels: some drivers fetch a whole texel at once but storage number by number.
layout(binding = FRAGMENT_TEXELS_LABEL) uniform usamplerBuffer labelTexels;
layout(binding = FRAGMENT_TEXELS_LATTICE) uniform usamplerBuffer latticeTexels;
layout(binding = FRAGMENT_TEXELS_POSITION) uniform samplerBuffer positionTexels;
layout(std430, binding = FRAGMENT_NEXT_LABELS) buffer NextLabels { uint nextLabel[]; };

uniform uint round_; // 1 ... FRAGMENT_LABEL_ROUNDS
uniform uint first;  // slots of this part of the round,
uniform uint last;   // excluded

uint labelOf(uint slot) { return texelFetch(labelTexels, int(slot)).x; }
uint latticeSlotAt(int index) { return texelFetch(latticeTexels, index).x; }

/// Of the particle in a cell of the lattice; where none is, greater than any, as is FRAGMENT_NO_LABEL.
uint labelAt(int index) {
    uint other = latticeSlotAt(index);
    return other != 0 ? labelOf(other - 1) : FRAGMENT_NO_LABEL;
}

bool bonded(uint mine, uint other) {
    return ((mine | other) & PHASE_FRESH) != 0 || fragmentOf(mine) == fragmentOf(other);
}

void lower(uint slot, uint to) {
    atomicMin(nextLabel[slot], to);
    atomicMax(control.lastChange, round_);
}

/// The smallest label among the lattice neighbours of a particle of the lattice. They are bonded whatever they are: no
/// free fragment is on the lattice.
uint smallestOnLattice(ivec3 centre, uint smallest) {
    ivec3 inside = centre & (TILE_EDGE - 1);
    ivec3 inner = ivec3(1, TILE_EDGE, TILE_EDGE * TILE_EDGE);
    ivec3 outer = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y) * TILE_CELLS - (TILE_EDGE - 1) * inner;
    ivec3 own = ivec3(latticeIndex(centre));
    // Beyond the lattice's end the particle finds itself.
    ivec3 low = own - mix(inner, outer, equal(inside, ivec3(0))) * ivec3(greaterThan(centre, ivec3(0)));
    ivec3 high = own + mix(inner, outer, equal(inside, ivec3(TILE_EDGE - 1))) *
                           ivec3(lessThan(centre, metal.tiles * TILE_EDGE - 1));
    smallest = min(smallest, min(labelAt(low.x), labelAt(high.x)));
    smallest = min(smallest, min(labelAt(low.y), labelAt(high.y)));
    return min(smallest, min(labelAt(low.z), labelAt(high.z)));
}

/// Goes on to the next of the 27 steps from (-1, -1, -1) to (1, 1, 1).
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
    if (labelOf(other) == FRAGMENT_NO_LABEL || !bonded(bits, phase[other])) return false;
    vec3 displacement = texelFetch(positionTexels, int(other)).xyz - place;
    float reach = FRAGMENT_BOND_LENGTH * metal.spacing;
    return dot(displacement, displacement) <= reach * reach;
}

/// The smallest label among the lattice particles bonded to a particle off the lattice. Lowers the labels on both sides: a
/// lattice particle does not look for those off the lattice.
uint smallestOfLattice(ivec3 centre, uint bits, vec3 place, uint own, uint smallest) {
    for (ivec3 step = ivec3(-1); step.z <= 1; nextStep(step)) {
        ivec3 cell = centre + step;
        if (!inLattice(cell)) continue;
        uint other = latticeSlotAt(int(latticeIndex(cell)));
        if (other == 0 || !isBondedNeighbour(other - 1, bits, place)) continue;
        uint theirs = labelOf(other - 1);
        smallest = min(smallest, theirs);
        if (own >= theirs) continue;
        lower(other - 1, own);
        lower(theirs, own);
    }
    return smallest;
}

uint smallestInList(uint list, uint bits, vec3 place, uint smallest) {
    for (uint other = head[list]; other != 0; other = next[other - 1])
        if (isBondedNeighbour(other - 1, bits, place)) smallest = min(smallest, labelOf(other - 1));
    return smallest;
}

/// The smallest label among the particles off the lattice that are bonded to one off the lattice.
uint smallestOffLattice(ivec3 centre, uint bits, vec3 place, uint smallest) {
    ivec3 low = max(centre - 1, ivec3(0));
    ivec3 high = min(centre + 1, fragmentBlock.coarseCells - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                uint cell = coarseIndex(ivec3(x, y, z));
                smallest = smallestInList(fixedList(cell), bits, place, smallest);
                smallest = smallestInList(freeList(cell), bits, place, smallest);
            }
    return smallest;
}

void labelSlot(uint slot) {
    uint own = labelOf(slot);
    if (own == FRAGMENT_NO_LABEL) return;
    uint bits = phase[slot];
    bool onLattice = (bits & PHASE_LATTICE) != 0;
    vec3 place = texelFetch(positionTexels, int(slot)).xyz;
    uint smallest = min(own, labelOf(own));
    if (onLattice) {
        smallest = smallestOnLattice(latticeCell(place), smallest);
    } else {
        smallest = smallestOfLattice(latticeCell(place), bits, place, own, smallest);
        smallest = smallestOffLattice(coarseCell(place), bits, place, smallest);
    }
    // A label names a particle of the same fragment, so that particle's label holds too: saves rounds.
    for (int jump = 0; jump < 3; ++jump) smallest = min(smallest, labelOf(smallest));
    if (smallest == own) return;
    lower(slot, smallest);
    lower(own, smallest);
}

// Few groups that stride over the slots: a round that has nothing left to do costs next to nothing.
void main() {
    bool settled = control.lastChange + 1 < round_; // the round before changed nothing
    uint end = settled ? 0 : last;
    for (uint slot = first + linearInvocation(); slot < end; slot += gl_NumWorkGroups.x * FRAGMENT_GROUP)
        labelSlot(slot);
}
