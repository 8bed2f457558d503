// One round of finding connected pieces: each solid particle, and the root it knew, take the smallest label among the particles
// bonded to it. Reads the old labels only and takes minima, so the result does not depend on the order of threads.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "pieces.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_LABEL) readonly buffer Labels { uint label[]; };
layout(std430, binding = PIECES_RELABEL) buffer Relabels { uint relabel[]; };

uniform uint round_; // 1 ... PIECES_ROUNDS
uniform uint first;  // slots of this part of the round,
uniform uint last;   // excluded

bool bonded(uint mine, uint other) {
    return ((mine | other) & PHASE_FRESH) != 0 || pieceOf(mine) == pieceOf(other);
}

void lower(uint slot, uint to) {
    atomicMin(relabel[slot], to);
    atomicMax(control.changed, round_);
}

/// The smallest label among the lattice neighbours of a particle of the lattice. They are bonded whatever they are: no
/// loose piece is on the lattice.
uint smallestOnLattice(ivec3 centre, uint smallest) {
    for (int face = 0; face < 6; ++face) {
        ivec3 cell = centre;
        cell[face >> 1] += (face & 1) * 2 - 1;
        if (!inLattice(cell)) continue;
        uint other = latticeSlot[latticeIndex(cell)];
        if (other != 0) smallest = min(smallest, label[other - 1]); // PIECE_NONE is greater than any
    }
    return smallest;
}

bool touches(uint other, uint bits, vec3 place) {
    if (label[other] == PIECE_NONE || !bonded(bits, phase[other])) return false;
    vec3 apart = position[other].xyz - place;
    float reach = PIECE_BOND * metal.origin.w;
    return dot(apart, apart) <= reach * reach;
}

/// Of metal off the lattice with that on it. It lowers the labels on both sides: the lattice need not look for it.
uint smallestAround(ivec3 centre, uint bits, vec3 place, uint own, uint smallest) {
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                ivec3 cell = centre + ivec3(x, y, z);
                if (!inLattice(cell)) continue;
                uint other = latticeSlot[latticeIndex(cell)];
                if (other == 0 || !touches(other - 1, bits, place)) continue;
                uint theirs = label[other - 1];
                smallest = min(smallest, theirs);
                if (own >= theirs) continue;
                lower(other - 1, own);
                lower(theirs, own);
            }
    return smallest;
}

uint smallestOfOthers(ivec3 centre, uint bits, vec3 place, uint smallest) {
    ivec3 low = max(centre - 1, ivec3(0));
    ivec3 high = min(centre + 1, pieces.coarse.xyz - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                for (uint other = head[coarseIndex(ivec3(x, y, z))]; other != 0; other = next[other - 1])
                    if (touches(other - 1, bits, place)) smallest = min(smallest, label[other - 1]);
    return smallest;
}

void main() {
    if (control.changed + 1 < round_) return; // the round before changed nothing
    uint slot = first + linearInvocation();
    if (slot >= last) return;
    uint own = label[slot];
    if (own == PIECE_NONE) return;
    uint bits = phase[slot];
    vec3 place = position[slot].xyz;
    uint smallest = min(own, label[own]);
    if ((bits & PHASE_LATTICE) != 0) {
        smallest = smallestOnLattice(latticeCell(place), smallest);
    } else {
        smallest = smallestAround(latticeCell(place), bits, place, own, smallest);
        smallest = smallestOfOthers(coarseCell(place), bits, place, smallest);
    }
    if (smallest == own) return;
    lower(slot, smallest);
    lower(own, smallest);
}
