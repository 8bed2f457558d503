// Gives every solid particle its first label: the end of gapless metal in its lattice tile, first along x, then along
// y, then along z, which is one particle in a full tile; its own slot if there is none before it. Links the solid
// particles off the lattice into the lists of their coarse cells.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "metal/solid/common.glsl"

layout(local_size_x = FRAGMENT_GROUP) in;
layout(binding = FRAGMENT_TEXELS_LATTICE) uniform usamplerBuffer latticeTexels;
layout(std430, binding = FRAGMENT_LABELS) writeonly buffer Labels { uint label[]; };
layout(std430, binding = FRAGMENT_FIRST_LABELS) writeonly buffer FirstLabels { uint firstLabel[]; };

/// Slot + 1 of the solid particle in a cell of the lattice, 0 for none.
uint solidAt(int index) {
    uint there = texelFetch(latticeTexels, index).x;
    return there != 0u && isSolid(phase[there - 1u]) ? there : 0u;
}

/// Goes back from a cell, `way` cells to its tile's end and `stride` apart, through gapless metal. `there`: slot + 1 of
/// the metal in the cell.
void goBack(inout int index, inout uint there, int way, int stride) {
    for (; way > 0; --way) {
        uint before = solidAt(index - stride);
        if (before == 0u) break;
        index -= stride;
        there = before;
    }
}

uint firstLabelOf(uint slot, ivec3 cell) {
    ivec3 way = cell & (TILE_EDGE - 1);
    int index = int(latticeIndex(cell));
    uint there = slot + 1u;
    goBack(index, there, way.x, 1);
    goBack(index, there, way.y, TILE_EDGE);
    goBack(index, there, way.z, TILE_EDGE * TILE_EDGE);
    return min(slot, there - 1u);
}

void main() {
    uint slot = linearInvocation();
    if (slot >= counters.particles) return;
    uint bits = phase[slot];
    uint first = FRAGMENT_NO_LABEL;
    if (isSolid(bits)) {
        vec3 place = position[slot].xyz;
        first = slot;
        if ((bits & PHASE_LATTICE) != 0u)
            first = firstLabelOf(slot, latticeCell(place));
        else
            link(slot, bits, place);
    }
    firstLabel[slot] = first;
    label[slot] = first;
}
