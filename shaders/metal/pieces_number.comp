// Numbers the loose pieces in the order of their roots; 0 for what a clamp holds, and for pieces too many to be told apart, which
// stay where they are until there is a number for them. One group.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "pieces.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_TALLY) readonly buffer Tallies { uint tally[]; };
layout(std430, binding = PIECES_NUMBER) writeonly buffer Numbers { uint number[]; };

#include "pieces_scan.glsl"

void main() {
    if (control.changed == PIECES_ROUNDS) return; // the labels are not final
    uint lane = gl_LocalInvocationID.x;
    uint found = 0;
    for (uint first = 0; first < counters.particles; first += PIECES_GROUP) {
        uint slot = first + lane;
        uint members = slot < counters.particles ? tally[slot] : 0;
        bool loose = members != 0 && (members & 0x80000000u) == 0;
        uint total;
        uint own = found + countBefore(loose, total) + 1;
        if (slot < counters.particles) number[slot] = !loose ? 0 : own <= PIECES_MOST ? own : 0;
        found += total;
    }
    if (lane != 0) return;
    control.pieces = min(found, PIECES_MOST);
    control.rejected = found - control.pieces;
}
