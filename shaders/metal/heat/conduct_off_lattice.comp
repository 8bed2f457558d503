#version 450 core
// Net power into each cell of the mixed tiles: conduction with its neighbours through the Kirchhoff variable, and the
// power of the sources. With SOURCES for the mixed tiles that a source may reach, else for the others. An invocation a
// cell. Metal off the lattice shares cells here: a face or a square conducts as the least filled of its cells allows.
// The particles themselves lose heat through the free surface later.
// SYNCHRONOUS_DRIVER: two programs and no branch, because it would compute a source's share in both.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/neighbours.glsl"
#include "metal/heat/cell_range.glsl"
#include "metal/heat/free_surface.glsl"
#include "metal/heat/stirring.glsl"
#include "metal/heat/squares.glsl"
#include "metal/heat/source.glsl"
#include "metal/heat/ledger.glsl"
layout(std430, binding = HEAT_CELL_POWER) restrict writeonly buffer CellPower { float cellPower[]; };
layout(std430, binding = HEAT_CONTROL) restrict readonly buffer Control { HeatControl control; };
#include "metal/heat/listed_rows.glsl"
layout(std430, binding = HEAT_SOURCE_SUMS) restrict readonly buffer SourceSums { float sourceSum[]; };

/// The exchange that keeps the particles of a cell with mean `theta`, which fills `weight` cells and takes in `flow`
/// (W/m), within the range of their cell and its surroundings. A particle takes flow + exchange (theta - own) by its
/// share of the weight. With the surroundings' whole conductance as exchange this is its own conduction, so no more is
/// ever needed: a particle with `own` at one end of the range of its cell then moves away from that end, or towards the
/// end of the surroundings by no more than the stability of explicit steps allows.
float exchangeFor(CellRange range, float theta, float weight, float flow, Surroundings around) {
    float gives = -flow - around.conductance * max(0.0, range.low - around.coldest);
    float takes = flow - around.conductance * max(0.0, around.hottest - range.high);
    float forColdest = gives > 0.0 ? gives / max(theta - range.low, 1e-6 * theta) : 0.0;
    float forHottest = takes > 0.0 ? takes / max(range.high - theta, 1e-6 * theta) : 0.0;
    return max(kCellExchange * weight, min(max(forColdest, forHottest), around.conductance));
}

/// Power of the sources into a cell, W.
float givenTo(ivec3 tilePlace, int inside, float weight, FreeSurface surface, float theta) {
    float given = 0.0;
#ifdef SOURCES
    for (int i = nextReaching(tilePlace, 0); i < heatBlock.sourceCount; i = nextReaching(tilePlace, i + 1)) {
        HeatSourceData s = heatBlock.sources[i];
        given += cellWeightIn(s, tilePlace, inside, weight, surface, theta) * sourceScale(s, sourceSum[i]);
    }
#endif
    return given;
}

void main() {
    uint entry = gl_GlobalInvocationID.x / TILE_EDGE;
#ifdef SOURCES
    if (entry >= control.reachedRows.w) return;
    int row = listedRow(placeOfMixed(true, entry));
#else
    if (entry >= control.unreachedRows.w) return;
    int row = listedRow(placeOfMixed(false, entry));
#endif
    int cell = TILE_EDGE * row + int(gl_LocalInvocationIndex % TILE_EDGE);
    int tile = cell / TILE_CELLS;
    int inside = cell % TILE_CELLS;
    int stamp = stampOf(tile);
    float theta = texelFetch(thetaTexels, thetaBase(stamp, tile) + inside).x;
    if (theta < 0.0) return;
    ivec3 tilePlace = tileCoordinate(tile);
    NeighbourOffsets offsets = neighbourOffsets(tilePlace, inside);
    Neighbours n = readNeighbours(tile, stamp, inside, offsets);
    Inflow inflow = inflowOf(ledNeighbours(n), anisotropicAlongAxes(vec3(theta)));
    bool awake = keepsAwake(inflow);
    float weight = weightOf(cell);
    Weights weights = readWeights(cell, offsets);
    vec3 fillLow = min(vec3(1), min(vec3(weight), weights.low));
    vec3 fillHigh = min(vec3(1), min(vec3(weight), weights.high));
    inflow.low *= fillLow;
    inflow.high *= fillHigh;
    Power power = powerOf(inflow, n);
    vec3 countLow = fillLow * vec3(n.openLow) * vec3(greaterThanEqual(n.low, vec3(0)));
    vec3 countHigh = fillHigh * vec3(n.openHigh) * vec3(greaterThanEqual(n.high, vec3(0)));
    SquareSum squares = squaresOf(tile, cell, stamp, theta, n, Side(offsets.low, offsets.edgeLow, n.low, countLow),
                                  Side(offsets.high, offsets.edgeHigh, n.high, countHigh));
    power.fromMetal += metal.spacing * squares.twist / 6.0;
    float flow = (power.fromMetal + power.fromWalls) / metal.spacing;
    if (isShared(cell)) {
        Surroundings around = surroundingsOf(inflow, n, fillLow, fillHigh);
        around.conductance -= squares.fill / 6.0;
        around.coldest = min(around.coldest, squares.coldest);
        around.hottest = max(around.hottest, squares.hottest);
        writeExchange(cell, exchangeFor(rangeOf(cell), theta, weight, flow, around));
    }
    FreeSurface surface = freeSurface(weight, weights);
    float given = givenTo(tilePlace, inside, weight, surface, theta);
    if (awake || given != 0.0) noteActivity(tile, notesOf(tile));
    cellPower[cell] = power.fromMetal + power.fromWalls + given;
    cellTheta[thetaBase(stamp ^ TILE_HALF, tile) + inside] = surface.area;
    book(cell, (power.fromWalls + given) * heatBlock.timeStep, 0.0);
}
