#version 450 core
// Removes values from a state to be saved that follow from the enthalpies: temperature and Kirchhoff variable become
// the bits in which they differ from the enthalpy's value, mostly none. A second run restores them, to the bit,
// whatever they were. An invocation a cell, then one a slot.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"

// The buffer's memory as words: only these preserve the bits of a NaN on every driver.
layout(std430, binding = METAL_POSITION) buffer PositionWords { uvec4 positionWords[]; };
layout(std430, binding = METAL_HEAT) buffer HeatWords { uvec4 heatWords[]; };
layout(std430, binding = HEAT_CELL_THETA) buffer ThetaWords { uint thetaWords[]; };

uniform uint cells;
uniform uint slots;

vec2 stateOf(uint slot) { return thermalState(uintBitsToFloat(heatWords[slot].x)); }

/// Folds a cell. Where there is metal, the half of the buffer that the next step does not read gets zeros; elsewhere it
/// is empty and must stay so.
void foldCell(uint cell) {
    const int stamp = tileStamp[cell / TILE_CELLS];
    const uint half_ = uint((stamp ^ (stamp >> 1)) & TILE_HALF); // a plain step changed halves
    const uint entry = latticeSlot[cell];
    const float theta = entry == 0u ? kEmpty : stateOf(entry - 1u).y;
    thetaWords[half_ * cells + cell] ^= floatBitsToUint(theta);
    const uint unread = (1u - half_) * cells + cell;
    thetaWords[unread] = entry == 0u ? thetaWords[unread] ^ floatBitsToUint(kEmpty) : 0u;
}

/// Folds a slot. The peak equals the temperature as long as metal gets hotter.
void foldSlot(uint slot) {
    const uint temperature = floatBitsToUint(stateOf(slot).x);
    positionWords[slot].w ^= temperature;
    heatWords[slot].z ^= temperature;
}

void main() {
    const uint at = linearInvocation();
    if (at < cells)
        foldCell(at);
    else if (at - cells < slots)
        foldSlot(at - cells);
}
