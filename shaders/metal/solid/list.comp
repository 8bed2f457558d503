// Lists the particles of loose pieces in ascending order and sets the sizes of the passes that move them. One group.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

layout(local_size_x = PIECES_GROUP) in;
layout(std430, binding = PIECES_LOOSE) writeonly buffer Loose { uint loose[]; };

#include "scan.glsl"

uvec4 groups(uint count) { return uvec4((count + PIECES_GROUP - 1) / PIECES_GROUP, 1, 1, 0); }

bool wanted(uint bits) { return solid(bits) && pieceOf(bits) != 0; }

void main() {
    uint lane = gl_LocalInvocationID.x;
    uint first = runStart(lane);
    uint end = runStart(lane + 1);
    uint mine = 0;
    for (uint slot = first; slot < end; ++slot) mine += wanted(phase[slot]) ? 1 : 0;
    uint found;
    uint place = sumBefore(mine, found);
    if (mine != 0)
        for (uint slot = first; slot < end; ++slot)
            if (wanted(phase[slot])) loose[place++] = slot;
    if (lane != 0) return;
    control.loose = found;
    control.looseGroups = groups(found);
    control.pieceGroups = uvec4(found == 0 ? 0 : control.pieces, 1, 1, 0);
    control.slotGroups = found == 0 ? uvec4(0, 1, 1, 0) : groups(counters.particles);
    control.cellGroups =
        found == 0 ? uvec4(0, 1, 1, 0) : groups(uint(pieces.coarse.x * pieces.coarse.y * pieces.coarse.z));
}
