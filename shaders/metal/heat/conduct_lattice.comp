#version 450 core
// A whole step of the plain tiles, where metal on the lattice conducts and its surface loses heat to the air, and
// nothing else happens: theta in one half of its buffer -> enthalpy, temperature, phase, theta in the other half. An
// invocation a row of four cells along x: a row and its neighbours along y and z are a texel each. The flow is that of
// stencil.glsl, as in the mixed tiles.
// SYNCHRONOUS_DRIVER: the whole pass; on a card the passes over mixed tiles would serve these tiles too. Such a driver
// executes every line whether its condition holds or not, but skips a loop that none of the parallel invocations
// enters: those passes do the work that only some tiles need, and a loop the work that only hot metal needs.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
#include "shared/heat.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/add_heat.glsl"
#include "metal/heat/surface_loss.glsl"
#include "metal/heat/ledger.glsl"
#include "metal/heat/leave_lattice.glsl"
#include "metal/heat/listed_rows.glsl"
#include "metal/heat/stencil.glsl"

layout(binding = HEAT_TEXELS_THETA_ROWS) uniform samplerBuffer thetaRows;
layout(binding = HEAT_TEXELS_LATTICE_ROWS) uniform usamplerBuffer latticeRows;

/// A tile that contains a row or its neighbours.
struct RowTile {
    int base;   // index of its theta
    bool there; // false beyond the lattice's end
    bool open;  // takes part in this step, so that both sides count the flow
};

/// `diagonal`: the tile shares only an edge with the row's own.
RowTile rowTile(int tile, bool there, bool diagonal) {
    const int stamp = stampOf(there ? tile : 0);
    const bool open = there && tookPart(stamp, heatBlock.stepNumber) && !(diagonal && (stamp & TILE_SHARED) != 0);
    return RowTile(thetaBase(stamp, there ? tile : 0), there, open);
}

/// Tiles side by side along x.
struct TileRow {
    RowTile before, here, after;
};

/// The tiles beside `own` in y or z, with `tile` in their middle.
TileRow tilesBeyond(TileRow own, int tile, bool there) {
    return TileRow(rowTile(tile - 1, there && own.before.there, true), rowTile(tile, there, false),
                   rowTile(tile + 1, there && own.after.there, true));
}

/// The way from a row to its neighbours along y or z, of which one may be in another tile.
struct Way {
    bool lowCrosses, highCrosses;
    int lowStep, highStep; // steps from row to row in the neighbour's tile
    int tileStep;          // step to that other tile
    bool there;            // false beyond the lattice's end
};

/// `at`: coordinate of the row in its tile along the axis; `inner`: from one row to the next; `stride`: from one tile to the
/// next; `tileAt`: coordinate of the tile along the axis, below `size`.
Way wayAlong(int at, int inner, int stride, int tileAt, int size) {
    const bool first = at == 0, last = at == TILE_EDGE - 1;
    const int across = (TILE_EDGE - 1) * inner;
    const bool there = first ? tileAt > 0 : last && tileAt + 1 < size;
    return Way(first, last, first ? across : -inner, last ? -across : inner, first ? -stride : stride, there);
}

/// Four cells along x and the cell at either end. Counts are 1 if metal conducts and its tile takes part, else 0.
struct Row {
    vec4 theta, counts;
    float countBefore, before, after, countAfter;
};

float countOf(float theta, bool counts) { return float(theta >= 0.0 && counts); }

Row rowIn(TileRow tiles, int row) {
    Row r;
    const int cell = TILE_EDGE * row;
    r.theta = texelFetch(thetaRows, tiles.here.base / TILE_EDGE + row);
    r.theta = tiles.here.there ? r.theta : vec4(kEmpty);
    r.counts = vec4(greaterThanEqual(r.theta, vec4(0))) * float(tiles.here.open);
    r.before = texelFetch(thetaTexels, tiles.before.base + cell + TILE_EDGE - 1).x;
    r.before = tiles.before.there ? r.before : kEmpty;
    r.after = texelFetch(thetaTexels, tiles.after.base + cell).x;
    r.after = tiles.after.there ? r.after : kEmpty;
    r.countBefore = countOf(r.before, tiles.before.open);
    r.countAfter = countOf(r.after, tiles.after.open);
    return r;
}

/// Flow into the four cells of a row.
struct RowInflow {
    vec4 metal_, walls; // W/m
    vec4 largest;       // difference to a neighbour, W/m
    // Sum over the axes of the squares of the numbers of open faces. Its root, the length of the sum of the open faces'
    // normals, is exact on planes along the lattice and on even slopes.
    vec4 openAxes;
};

void addAxis(inout RowInflow sum, vec4 theta, vec4 low, vec4 high, vec4 countLow, vec4 countHigh) {
    const bvec4 wallLow = lessThan(low, vec4(-1.5));
    const bvec4 wallHigh = lessThan(high, vec4(-1.5));
    const vec4 fromLow = faceFlow(low, theta, wallLow);
    const vec4 fromHigh = faceFlow(high, theta, wallHigh);
    sum.walls += fromLow * vec4(wallLow) + fromHigh * vec4(wallHigh);
    sum.metal_ += fromLow * countLow + fromHigh * countHigh;
    sum.largest = max(sum.largest, max(abs(fromLow), abs(fromHigh)));
    const vec4 open = vec4(equal(low, vec4(kEmpty))) + vec4(equal(high, vec4(kEmpty)));
    sum.openAxes += open * open;
}

/// Sum of the twists of the squares that each cell of a row makes with its neighbours along x and in another row.
vec4 twistAlongX(Row own, Row other) {
    // Differences across to the other row, then along x.
    const vec4 across = own.theta - other.theta;
    const vec4 counts = own.counts * other.counts;
    const float before = own.before - other.before, after = own.after - other.after;
    const float countBefore = own.countBefore * other.countBefore, countAfter = own.countAfter * other.countAfter;
    const vec4 low = (across - vec4(before, across.xyz)) * (counts * vec4(countBefore, counts.xyz));
    return low + vec4(-low.yzw, (across.w - after) * (counts.w * countAfter));
}

/// Sum of the twists of the square with a row along y, one along z and the one diagonally opposite in `tile`.
vec4 twistAcross(Row own, Row y, Row z, RowTile tile, int row) {
    const vec4 corner = texelFetch(thetaRows, tile.base / TILE_EDGE + row);
    const vec4 counts = own.counts * y.counts * z.counts * vec4(greaterThanEqual(corner, vec4(0))) * float(tile.open);
    return twistOf(own.theta, y.theta, z.theta, corner) * counts;
}

RowInflow inflowOfRow(int tile, int row, TileRow side, Row own) {
    const ivec3 place = tileCoordinate(tile);
    const ivec3 size = metal.tiles;
    const Way y = wayAlong(row % TILE_EDGE, 1, size.x, place.y, size.y);
    const Way z = wayAlong(row / TILE_EDGE, TILE_EDGE, size.x * size.y, place.z, size.z);
    const TileRow beyondY = tilesBeyond(side, tile + y.tileStep, y.there);
    const TileRow beyondZ = tilesBeyond(side, tile + z.tileStep, z.there);
    const RowTile beyondBoth = rowTile(tile + y.tileStep + z.tileStep, y.there && z.there, true);
    const Row lowY = rowIn(y.lowCrosses ? beyondY : side, row + y.lowStep);
    const Row highY = rowIn(y.highCrosses ? beyondY : side, row + y.highStep);
    const Row lowZ = rowIn(z.lowCrosses ? beyondZ : side, row + z.lowStep);
    const Row highZ = rowIn(z.highCrosses ? beyondZ : side, row + z.highStep);
#define CORNER(A, B)                                                                                                   \
    twistAcross(own, A##Y, B##Z,                                                                                       \
                y.A##Crosses ? (z.B##Crosses ? beyondBoth : beyondY.here) : (z.B##Crosses ? beyondZ.here : side.here), \
                row + y.A##Step + z.B##Step)
    const vec4 twist = (twistAlongX(own, lowY) + twistAlongX(own, highY)) + (twistAlongX(own, lowZ) + twistAlongX(own, highZ)) +
                       (CORNER(low, low) + CORNER(high, low)) + (CORNER(low, high) + CORNER(high, high));
#undef CORNER
    RowInflow sum = RowInflow(twist / 6.0, vec4(0), vec4(0), vec4(0));
    addAxis(sum, own.theta, vec4(own.before, own.theta.xyz), vec4(own.theta.yzw, own.after),
            vec4(own.countBefore, own.counts.xyz), vec4(own.counts.yzw, own.countAfter));
    addAxis(sum, own.theta, lowY.theta, highY.theta, lowY.counts, highY.counts);
    addAxis(sum, own.theta, lowZ.theta, highZ.theta, lowZ.counts, highZ.counts);
    return sum;
}

/// Findings of a cell's step, for the notes of its tile.
struct Found {
    bool awake, warm, evaporating;
    bool hot; // metal was at its solidus or above before or after the step: no other changes its phase
};

/// Makes the step of one cell; returns its enthalpy. No-op in an empty cell or at a fixed temperature.
float advance(int cell, int otherHalf, uint entry, float theta, float metalFlow, float wallFlow, float largest,
              float openAxes, float elapsed, inout Found found) {
    if (theta < 0.0) {
        cellTheta[otherHalf] = theta;
        return 0.0;
    }
    const float dx = metal.spacing;
    const vec2 power = dx * vec2(metalFlow, wallFlow);
    const uint slot = entry - 1u;
    const vec4 h = texelFetch(heatTexels, int(slot));
    const float temperature = texelFetch(positionTexels, int(slot)).w; // value of the last step
    const float losing = surfaceLoss(temperature, sqrt(openAxes) * dx * dx);
    const float lost = losing * elapsed; // may be due for several steps at once
    book(cell, power.y * heatBlock.timeStep, lost);
    const Heated heated = addHeat(slot, h, temperature, (power.x + power.y) * heatBlock.timeStep - lost, elapsed);
    cellTheta[otherHalf] = heated.theta;
    const bool losesMuch = abs(losing) * heatBlock.timeStep > heatBlock.wakingLoss;
    found.awake = found.awake || largest > heatBlock.wakingThetaDifference || losesMuch;
    found.warm = found.warm || (losing != 0.0 && abs(temperature - heatBlock.ambient) > heatBlock.warmAboveAmbient);
#ifdef EVAPORATION
    found.evaporating = found.evaporating || evaporates(heated.temperature);
#endif
    found.hot = found.hot || max(h.x, heated.enthalpy) >= metal.solidusEnthalpy;
    return heated.enthalpy;
}

void main() {
    if (gl_GlobalInvocationID.x >= control.plainRows.w) return;
    const int listed = listedRow(gl_GlobalInvocationID.x);
    const int tile = listed / TILE_ROWS;
    const int row = listed % TILE_ROWS;
    const int cell = tile * TILE_CELLS + TILE_EDGE * row;
    const int stamp = stampOf(tile);
    const int other = thetaBase(stamp ^ TILE_HALF, tile) + TILE_EDGE * row;
    const ivec3 place = tileCoordinate(tile);
    const TileRow side = TileRow(rowTile(tile - 1, place.x > 0, false), rowTile(tile, true, false),
                                 rowTile(tile + 1, place.x + 1 < metal.tiles.x, false));
    const Row own = rowIn(side, row);
    const vec4 theta = own.theta;
    const RowInflow f = inflowOfRow(tile, row, side, own);
    const uvec4 entry = texelFetch(latticeRows, cell / TILE_EDGE);
    const float elapsed = elapsedOf(tile);
    Found found = Found(false, false, false, false);
    vec4 enthalpy;
#define ADVANCE(C, I)                                                                                                  \
    enthalpy.C = advance(cell + I, other + I, entry.C, theta.C, f.metal_.C, f.walls.C, f.largest.C, f.openAxes.C, elapsed, found)
    ADVANCE(x, 0);
    ADVANCE(y, 1);
    ADVANCE(z, 2);
    ADVANCE(w, 3);
#undef ADVANCE
    for (int i = found.hot ? 0 : TILE_EDGE; i < TILE_EDGE; ++i) {
        const bvec4 which = equal(ivec4(i), ivec4(0, 1, 2, 3));
        const uint filled = which.x ? entry.x : which.y ? entry.y : which.z ? entry.z : entry.w;
        if (dot(theta, vec4(which)) >= 0.0) writePhase(filled - 1u, cell + i, other + i, dot(enthalpy, vec4(which)));
    }
    const TileNotes notes = notesOf(tile);
    if (found.awake) noteActivity(tile, notes);
    const int now = heatBlock.stepNumber;
    if (found.warm && now - notes.lastWarm >= TILE_NOTE_INTERVAL) tiles[tile].lastWarm = now;
#ifdef EVAPORATION
    if (found.evaporating && now - notes.lastEvaporating >= TILE_NOTE_INTERVAL) tiles[tile].lastEvaporating = now;
#endif
}
