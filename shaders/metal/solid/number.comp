// Numbers the loose pieces in the order of their roots; 0 for what a clamp holds, and for pieces too many to be told apart, which
// stay where they are until there is a number for them. One group.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_TALLY) readonly buffer Tallies { uint tally[]; };
layout(std430, binding = PIECES_NUMBER) writeonly buffer Numbers { uint number[]; };

#include "scan.glsl"

bool loose(uint slot) { return tally[slot] != 0 && (tally[slot] & 0x80000000u) == 0; }

void main() {
    if (control.changed == PIECES_ROUNDS) return; // the labels are not final
    uint lane = gl_LocalInvocationID.x;
    uint first = runStart(lane);
    uint end = runStart(lane + 1);
    uint mine = 0;
    for (uint slot = first; slot < end; ++slot) mine += loose(slot) ? 1 : 0;
    uint found;
    uint own = sumBefore(mine, found);
    for (uint slot = first; slot < end; ++slot) {
        bool counts = loose(slot);
        own += counts ? 1 : 0;
        number[slot] = counts && own <= PIECES_MOST ? own : 0;
    }
    if (lane != 0) return;
    control.pieces = min(found, PIECES_MOST);
    control.rejected = found - control.pieces;
}
