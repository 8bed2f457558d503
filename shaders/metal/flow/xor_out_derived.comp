#version 450 core
#extension GL_GOOGLE_include_directive : require
// Removes values from a state to be saved that follow from the metal's places: the flow's own copies of them become the
// bits in which they differ, mostly none. A second run restores them, to the bit, whatever they were. An invocation a
// slot, then one a cell.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;

// The buffer's memory as words, which preserve their bits on every driver.
layout(std430, binding = FLOW_PARTICLES) buffer ParticleWords { uvec4 particleWords[]; };

uniform uint slots;

void foldParticle(uint slot) {
    const uint first = FLOW_PARTICLE_TEXELS * slot; // texels of a FlowParticle: the first holds its place, the third its velocity
    particleWords[first].xyz ^= floatBitsToUint(position[slot].xyz);
    particleWords[first + 2].xyz ^= floatBitsToUint(velocity[slot].xyz);
}

/// Clears the part of a page beyond its cell's wall metal, which no pass reads.
void foldPage(uint cell) {
    if (cells[cell].wallPage == 0) return;
    const uint base = wallBase(cells[cell].wallPage);
    for (uint k = 0; k < FLOW_CELL_CAPACITY; ++k) {
        const uint slot = pages[pageSlotIndex(base + k)];
        const bool listed = k < cells[cell].walls;
        writePageEntry(base + k, listed ? pages[base + k] ^ packPosition(position[slot].xyz) : 0, listed ? slot : 0);
    }
}

void main() {
    const uint at = gl_GlobalInvocationID.x;
    if (at < slots)
        foldParticle(at);
    else if (at - slots < fluid.cellCount)
        foldPage(at - slots);
}
