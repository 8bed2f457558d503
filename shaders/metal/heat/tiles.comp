#version 450 core
// Lists the tiles that take part in this step: where something happens, beside those, where a source reaches, and where loose
// metal is. Resting warm tiles take their turn for the surface loss.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
layout(std430, binding = HEAT_LISTS) restrict writeonly buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_CONTROL) restrict buffer Control { HeatControl control; };

bool busy(ivec4 notes) { return heatBlock.step.x - notes.x <= TILE_PATIENCE; }
bool holdsLoose(ivec4 notes) { return notes.y == heatBlock.step.x; }

bool underSource(ivec3 place) {
    bool under = false;
    for (int i = 0; i < heatBlock.step.y; ++i) under = under || reaches(heatBlock.sources[i], place);
    return under;
}

/// What goes on in the tiles beside a tile: x something happens, y loose metal.
bvec2 besideTile(int tile, ivec3 place) {
    bvec2 beside = bvec2(false);
    ivec3 stride = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y);
    for (int axis = 0; axis < 3; ++axis)
        for (int side = -1; side <= 1; side += 2) {
            int there = place[axis] + side;
            if (there < 0 || there >= metal.tiles[axis]) continue;
            ivec4 notes = notesOf(tile + side * stride[axis]);
            beside = bvec2(beside.x || busy(notes), beside.y || holdsLoose(notes));
        }
    return beside;
}

/// Simulated time since a tile last took part, this step included, s.
float sinceStep(int tile, int stamp) {
    if (tookPart(stamp, heatBlock.step.x - 1)) return heatBlock.time.x;
    return float(heatBlock.clock.x - tiles[tile].upTo) * 1e-6;
}

void main() {
    int tile = int(linearInvocation());
    if (tile >= heatBlock.step.w) return;
    int stamp = stampOf(tile);
    ivec4 notes = notesOf(tile);
    bool loose = holdsLoose(notes);
    if (stamp <= TILE_NO_METAL && !loose) return;
    ivec3 place = tileCoordinate(tile);
    bvec2 beside = besideTile(tile, place);
    bool source = underSource(place);
    bool warm = (stamp >> TILE_STEP_SHIFT) - notes.z < TILE_NOTE;
    bool turn = warm && (heatBlock.step.x + tile) % TILE_REST == 0;
    int half_ = (stamp ^ (stamp >> 1)) & TILE_HALF; // a plain step changed halves
    if (!(turn || loose || source || any(beside) || busy(notes))) {
        if ((stamp & TILE_PLAIN) != 0) tileStamp[tile] = (stamp & ~3) | half_;
        return;
    }
    bool mixed = loose || beside.y || source;
#ifdef EVAPORATION
    mixed = mixed || heatBlock.step.x - notes.w <= TILE_PATIENCE;
#endif
    tiles[tile].since = sinceStep(tile, stamp);
    tiles[tile].upTo = heatBlock.clock.x;
    tileStamp[tile] = heatBlock.step.x << TILE_STEP_SHIFT | (mixed ? 0 : TILE_PLAIN) | half_;
    if (mixed)
        lists[heatBlock.step.w + int(atomicAdd(control.mixed.x, 1u))] = uint(tile);
    else
        lists[atomicAdd(control.plain.x, 1u)] = uint(tile);
    if (loose) lists[2 * heatBlock.step.w + int(atomicAdd(control.sums.x, 1u))] = uint(tile);
}
