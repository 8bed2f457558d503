#version 450 core
// Lists the tiles that take part in this step: where something happens, beside those, and where a source reaches. Resting
// warm tiles take their turn for the surface loss.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat_common.glsl"
layout(std430, binding = HEAT_TILE_LIST) restrict writeonly buffer TileList { uint tileList[]; };
layout(std430, binding = HEAT_INDIRECT) restrict buffer Indirect { uvec4 indirect; };

bool busy(int tile) { return heatBlock.step.x - tiles[tile].lastNeed <= int(TILE_PATIENCE); }

bool besideBusy(int tile, ivec3 place) {
    ivec3 stride = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y);
    for (int axis = 0; axis < 3; ++axis) {
        if (place[axis] > 0 && busy(tile - stride[axis])) return true;
        if (place[axis] + 1 < metal.tiles[axis] && busy(tile + stride[axis])) return true;
    }
    return false;
}

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
    ivec3 place = tileCoordinate(tile);
    bool turn = tiles[tile].lastWarm == tileStamp[tile] && (heatBlock.step.x + tile) % int(TILE_REST) == 0;
    // Time since the end of the step it last took part in, this step included.
    float waited = tileStamp[tile] == heatBlock.step.x - 1 ? 0.0 : tiles[tile].since;
    tiles[tile].since = waited + heatBlock.time.x;
    if (turn || busy(tile) || underSource(place) || besideBusy(tile, place)) {
        tileStamp[tile] = heatBlock.step.x;
        tileList[atomicAdd(indirect.x, 1u)] = uint(tile);
    }
}
