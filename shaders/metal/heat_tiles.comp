#version 450 core
// Lists the tiles that take part in this step: where something happens, beside those, where a source reaches, and where loose
// metal is. Resting warm tiles take their turn for the surface loss.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat_common.glsl"
layout(std430, binding = HEAT_LISTS) restrict writeonly buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_CONTROL) restrict buffer Control { HeatControl control; };

bool busy(int tile) { return heatBlock.step.x - tiles[tile].lastNeed <= int(TILE_PATIENCE); }
bool holdsLoose(int tile) { return tiles[tile].lastLoose == heatBlock.step.x; }

bool underSource(ivec3 place) {
    for (int i = 0; i < heatBlock.step.y; ++i) {
        ivec3 low = heatBlock.sources[i].lowTile.xyz;
        ivec3 count = heatBlock.sources[i].tileCount.xyz;
        if (all(greaterThanEqual(place, low)) && all(lessThan(place, low + count))) return true;
    }
    return false;
}

void main() {
    int tile = int(linearInvocation());
    if (tile >= heatBlock.step.w) return;
    bool loose = holdsLoose(tile);
    if (tileStamp[tile] == TILE_NO_METAL && !loose) return;
    ivec3 place = tileCoordinate(tile);
    ivec3 stride = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y);
    bool besideBusy = false;
    bool besideLoose = false;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = -1; side <= 1; side += 2) {
            int beside = place[axis] + side;
            if (beside < 0 || beside >= metal.tiles[axis]) continue;
            besideBusy = besideBusy || busy(tile + side * stride[axis]);
            besideLoose = besideLoose || holdsLoose(tile + side * stride[axis]);
        }
    bool turn = tiles[tile].lastWarm == tileStamp[tile] && (heatBlock.step.x + tile) % int(TILE_REST) == 0;
    // Time since the end of the step it last took part in, this step included.
    float waited = tileStamp[tile] == heatBlock.step.x - 1 ? 0.0 : tiles[tile].since;
    tiles[tile].since = waited + heatBlock.time.x;
    if (!(turn || loose || besideLoose || besideBusy || busy(tile) || underSource(place))) return;
    tileStamp[tile] = heatBlock.step.x;
    if (loose || besideLoose)
        lists[heatBlock.step.w + int(atomicAdd(control.mixed.x, 1u))] = uint(tile);
    else
        lists[atomicAdd(control.plain.x, 1u)] = uint(tile);
    if (loose) lists[2 * heatBlock.step.w + int(atomicAdd(control.sums.x, 1u))] = uint(tile);
}
