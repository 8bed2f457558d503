// One round of finding connected pieces: each solid particle, and the root it knew, take the smallest label among the particles
// bonded to it. Reads the old labels only and takes minima, so the result does not depend on the order of threads.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "pieces.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_LABEL) readonly buffer Labels { uint label[]; };
layout(std430, binding = PIECES_RELABEL) buffer Relabels { uint relabel[]; };

uniform uint round_; // 1 ... PIECES_ROUNDS

bool bonded(uint mine, uint other) {
    return ((mine | other) & PHASE_FRESH) != 0 || pieceOf(mine) == pieceOf(other);
}

void visit(uint other, uint bits, vec3 place, inout uint smallest) {
    if (label[other] == PIECE_NONE || !bonded(bits, phase[other])) return;
    vec3 apart = position[other].xyz - place;
    float reach = PIECE_BOND * metal.origin.w;
    if (dot(apart, apart) <= reach * reach) smallest = min(smallest, label[other]);
}

void visitLattice(ivec3 centre, bool facesOnly, uint bits, vec3 place, inout uint smallest) {
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                if (facesOnly && abs(x) + abs(y) + abs(z) != 1) continue;
                ivec3 cell = centre + ivec3(x, y, z);
                if (!inLattice(cell)) continue;
                uint other = latticeSlot[latticeIndex(cell)];
                if (other != 0) visit(other - 1, bits, place, smallest);
            }
}

void visitOthers(ivec3 centre, uint bits, vec3 place, inout uint smallest) {
    ivec3 low = max(centre - 1, ivec3(0));
    ivec3 high = min(centre + 1, pieces.coarse.xyz - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                for (uint other = head[coarseIndex(ivec3(x, y, z))]; other != 0; other = next[other - 1])
                    visit(other - 1, bits, place, smallest);
}

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles) return;
    uint own = label[slot];
    if (own == PIECE_NONE) return;
    uint bits = phase[slot];
    vec3 place = position[slot].xyz;
    uint smallest = min(own, label[own]);
    visitLattice(latticeCell(place), (bits & PHASE_LATTICE) != 0, bits, place, smallest);
    visitOthers(coarseCell(place), bits, place, smallest);
    if (smallest == own) return;
    atomicMin(relabel[slot], smallest);
    atomicMin(relabel[own], smallest);
    atomicMax(control.changed, round_);
}
