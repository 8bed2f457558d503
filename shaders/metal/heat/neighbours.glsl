// Conduction between a cell and its six neighbours, for passes with an invocation a cell. Included after common.glsl.
#include "metal/heat/stencil.glsl"

/// The neighbours of a cell along x, y and z, on the low and on the high side.
/// SYNCHRONOUS_DRIVER: no loops over axes, because it holds arrays that are indexed at run time in memory.
struct NeighbourOffsets {
    ivec3 low, high;       // offset from the cell; 0 beyond the lattice's end, where the cell is its own neighbour
    bvec3 edgeLow, edgeHigh; // the neighbour is in another tile
    bvec3 endLow, endHigh; // beyond the lattice's end: no neighbour
};

NeighbourOffsets neighbourOffsets(ivec3 tilePlace, int inside) {
    NeighbourOffsets offsets;
    ivec3 at = insideCoordinate(inside);
    ivec3 inner = ivec3(1, 4, 16);
    ivec3 outer = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y) * TILE_CELLS - (TILE_EDGE - 1) * inner;
    offsets.edgeLow = equal(at, ivec3(0));
    offsets.edgeHigh = equal(at, ivec3(TILE_EDGE - 1));
    offsets.endLow = bvec3(ivec3(offsets.edgeLow) & ivec3(equal(tilePlace, ivec3(0))));
    offsets.endHigh = bvec3(ivec3(offsets.edgeHigh) & ivec3(equal(tilePlace, metal.tiles - 1)));
    offsets.low = -mix(mix(inner, outer, offsets.edgeLow), ivec3(0), offsets.endLow);
    offsets.high = mix(mix(inner, outer, offsets.edgeHigh), ivec3(0), offsets.endHigh);
    return offsets;
}

/// Values of the six neighbouring cells.
struct Neighbours {
    vec3 low, high;          // Kirchhoff variable
    bvec3 openLow, openHigh; // the neighbour's tile takes part in this step, so that both sides count the flow
    ivec3 tiles, stamps;     // tile and stamp of the neighbour in another tile; the cell's own if there is none
};

/// The six neighbours of cell `inside` of `tile`, which takes part in this step with `stamp`.
Neighbours readNeighbours(int tile, int stamp, int inside, NeighbourOffsets offsets) {
    Neighbours n;
    ivec3 tileStride = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y);
    // A cell has at most one neighbouring tile along an axis.
    ivec3 others = ivec3(tile) + mix(ivec3(0), tileStride, offsets.edgeHigh) - mix(ivec3(0), tileStride, offsets.edgeLow);
    others = mix(others, ivec3(tile), bvec3(ivec3(offsets.endLow) | ivec3(offsets.endHigh)));
    ivec3 stamps = ivec3(stampOf(others.x), stampOf(others.y), stampOf(others.z));
    bvec3 open = equal(stamps >> TILE_STEP_SHIFT, ivec3(heatBlock.stepNumber));
    // The stamp of a sleeping tile whose last step was plain names the right half: list_tiles.comp corrected it.
    ivec3 own = ivec3(thetaBase(stamp, tile) + inside);
    ivec3 shift = ((stamps & TILE_HALF) - (stamp & TILE_HALF)) * (heatBlock.tileCount * TILE_CELLS);
    ivec3 low = own + offsets.low + mix(ivec3(0), shift, offsets.edgeLow);
    ivec3 high = own + offsets.high + mix(ivec3(0), shift, offsets.edgeHigh);
    n.low = vec3(texelFetch(thetaTexels, low.x).x, texelFetch(thetaTexels, low.y).x, texelFetch(thetaTexels, low.z).x);
    n.high = vec3(texelFetch(thetaTexels, high.x).x, texelFetch(thetaTexels, high.y).x, texelFetch(thetaTexels, high.z).x);
    n.low = mix(n.low, vec3(kEmpty), offsets.endLow);
    n.high = mix(n.high, vec3(kEmpty), offsets.endHigh);
    n.openLow = bvec3(ivec3(not(offsets.edgeLow)) | ivec3(open));
    n.openHigh = bvec3(ivec3(not(offsets.edgeHigh)) | ivec3(open));
    n.tiles = others;
    n.stamps = stamps;
    return n;
}

/// Power into a cell from each side over one spacing (W/m) as conduction gives it: two cells exchange dx (theta_j - theta_i),
/// k A/dx with k inside theta. A held neighbour is a wall at the face between the two, half as far away.
struct Inflow {
    vec3 low, high;
    bvec3 wallLow, wallHigh;
};

Inflow inflowOf(Neighbours n, vec3 theta) {
    Inflow f;
    f.wallLow = lessThan(n.low, vec3(-1.5));
    f.wallHigh = lessThan(n.high, vec3(-1.5));
    f.low = faceFlow(n.low, theta, f.wallLow);
    f.high = faceFlow(n.high, theta, f.wallHigh);
    return f;
}

/// True if the differences to the neighbours are worth another step.
bool keepsAwake(Inflow f) {
    vec3 largest = max(abs(f.low), abs(f.high));
    return max(max(largest.x, largest.y), largest.z) > heatBlock.wakingThetaDifference;
}

/// Net power into a cell, W.
struct Power {
    float fromMetal, fromWalls;
};

/// The power through faces whose tiles both take part, so that one side's loss is the other's gain; a wall's heat comes
/// from outside the metal and needs no open partner.
Power powerOf(Inflow f, Neighbours n) {
    vec3 walls = f.low * vec3(f.wallLow) + f.high * vec3(f.wallHigh);
    vec3 metal_ = f.low * vec3(n.openLow) * vec3(not(f.wallLow)) + f.high * vec3(n.openHigh) * vec3(not(f.wallHigh));
    return Power(metal.spacing * (metal_.x + metal_.y + metal_.z), metal.spacing * (walls.x + walls.y + walls.z));
}

/// Surroundings of a cell's conduction: the sum of the conductances of its faces, in those of two full neighbouring
/// cells, and the range of theta behind them.
struct Surroundings {
    float conductance;
    float coldest, hottest;
};

/// `fillLow` and `fillHigh`: share of a full face that conducts, as in the inflow.
Surroundings surroundingsOf(Inflow f, Neighbours n, vec3 fillLow, vec3 fillHigh) {
    vec3 low = mix(n.low, -2.0 - n.low, f.wallLow);
    vec3 high = mix(n.high, -2.0 - n.high, f.wallHigh);
    vec3 countLow = fillLow * mix(vec3(n.openLow) * vec3(notEqual(n.low, vec3(kEmpty))), vec3(2), f.wallLow);
    vec3 countHigh = fillHigh * mix(vec3(n.openHigh) * vec3(notEqual(n.high, vec3(kEmpty))), vec3(2), f.wallHigh);
    bvec3 nothingLow = equal(countLow, vec3(0)), nothingHigh = equal(countHigh, vec3(0));
    vec3 coldest = min(mix(low, vec3(3.4e38), nothingLow), mix(high, vec3(3.4e38), nothingHigh));
    vec3 hottest = max(mix(low, vec3(0), nothingLow), mix(high, vec3(0), nothingHigh));
    return Surroundings(dot(countLow + countHigh, vec3(1)), min(min(coldest.x, coldest.y), coldest.z),
                        max(max(hottest.x, hottest.y), hottest.z));
}
