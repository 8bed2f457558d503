#version 450 core
// A whole step of the plain tiles, where metal on the lattice conducts and its surface loses heat to the air, and nothing
// else happens: theta in one half of its buffer -> enthalpy, temperature, phase, theta in the other half. One group a tile,
// an invocation for each row of four cells along x: a row and its neighbours along y and z are a texel each.
// Drivers that run on the CPU execute every line whether its condition holds or not: what only some tiles need is left to the
// passes over mixed tiles.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
#include "shared/metal.h"
layout(local_size_x = TILE_CELLS / TILE_EDGE) in;
#include "metal/heat/common.glsl"
#include "metal/heat/add_heat.glsl"
#include "metal/heat/surface_loss.glsl"
#include "metal/heat/ledger.glsl"
#include "metal/heat/leave_lattice.glsl"

layout(binding = HEAT_TEXELS_THETA_ROWS) uniform samplerBuffer thetaRows;
layout(binding = HEAT_TEXELS_LATTICE_ROWS) uniform usamplerBuffer latticeRows;

/// A neighbouring tile.
struct NeighbourTile {
    int base;   // of its theta
    bool there; // not beyond the lattice's end
    bool open;  // it takes part in this step, so that both sides count the flow
};

NeighbourTile neighbourTile(int tile, int step, bool there) {
    const int stamp = stampOf(there ? tile + step : tile);
    return NeighbourTile(thetaBase(stamp, there ? tile + step : tile), there, tookPart(stamp, heatBlock.stepNumber));
}

vec4 rowOf(int base, int row) { return texelFetch(thetaRows, base / TILE_EDGE + row); }

/// The neighbours of a row along y or z, of which one may be in another tile.
struct NeighbourRows {
    vec4 low, high;
    bool openLow, openHigh;
};

/// `at`: coordinate of the row in its tile along the axis; `inner`: from one row to the next; `stride`: from one tile to the
/// next; `tileAt`: coordinate of the tile along the axis, below `size`.
NeighbourRows neighbourRows(int tile, int base, int row, int at, int inner, int stride, int tileAt, int size) {
    const bool first = at == 0, last = at == TILE_EDGE - 1;
    const NeighbourTile other = neighbourTile(tile, first ? -stride : stride, first ? tileAt > 0 : last && tileAt + 1 < size);
    const int across = (TILE_EDGE - 1) * inner;
    NeighbourRows rows;
    rows.low = rowOf(first ? other.base : base, row + (first ? across : -inner));
    rows.high = rowOf(last ? other.base : base, row + (last ? -across : inner));
    rows.low = first && !other.there ? vec4(kEmpty) : rows.low;
    rows.high = last && !other.there ? vec4(kEmpty) : rows.high;
    rows.openLow = !first || other.open;
    rows.openHigh = !last || other.open;
    return rows;
}

/// What flows into the four cells of a row: as Inflow and powerOf() in neighbours.glsl for one cell.
struct RowInflow {
    vec4 metal_, walls; // W/m
    vec4 largest;       // difference to a neighbour, W/m
    // Sum over the axes of the squares of how many faces are open. Its root, the length of the sum of the open faces' normals,
    // is exact on planes along the lattice and on even slopes.
    vec4 openAxes;
};

vec4 sideInflow(vec4 neighbour, vec4 theta, bvec4 wall) {
    return mix(neighbour - theta, 2.0 * (-2.0 - neighbour - theta), wall) * (1.0 - vec4(equal(neighbour, vec4(kEmpty))));
}

void addAxis(inout RowInflow sum, vec4 theta, vec4 low, vec4 high, vec4 openLow, vec4 openHigh) {
    const bvec4 wallLow = lessThan(low, vec4(-1.5));
    const bvec4 wallHigh = lessThan(high, vec4(-1.5));
    const vec4 fromLow = sideInflow(low, theta, wallLow);
    const vec4 fromHigh = sideInflow(high, theta, wallHigh);
    sum.walls += fromLow * vec4(wallLow) + fromHigh * vec4(wallHigh);
    sum.metal_ += fromLow * openLow * vec4(not(wallLow)) + fromHigh * openHigh * vec4(not(wallHigh));
    sum.largest = max(sum.largest, max(abs(fromLow), abs(fromHigh)));
    const vec4 open = vec4(equal(low, vec4(kEmpty))) + vec4(equal(high, vec4(kEmpty)));
    sum.openAxes += open * open;
}

RowInflow inflowOfRow(int tile, int base, int row, vec4 theta) {
    const ivec3 place = tileCoordinate(tile);
    const ivec3 size = metal.tiles;
    const NeighbourTile before = neighbourTile(tile, -1, place.x > 0);
    const NeighbourTile after = neighbourTile(tile, 1, place.x + 1 < size.x);
    const float ahead = before.there ? texelFetch(thetaTexels, before.base + TILE_EDGE * row + TILE_EDGE - 1).x : kEmpty;
    const float behind = after.there ? texelFetch(thetaTexels, after.base + TILE_EDGE * row).x : kEmpty;
    const NeighbourRows y = neighbourRows(tile, base, row, row % TILE_EDGE, 1, size.x, place.y, size.y);
    const NeighbourRows z = neighbourRows(tile, base, row, row / TILE_EDGE, TILE_EDGE, size.x * size.y, place.z, size.z);
    RowInflow sum = RowInflow(vec4(0), vec4(0), vec4(0), vec4(0));
    addAxis(sum, theta, vec4(ahead, theta.xyz), vec4(theta.yzw, behind), vec4(before.open, 1, 1, 1),
            vec4(1, 1, 1, after.open));
    addAxis(sum, theta, y.low, y.high, vec4(y.openLow), vec4(y.openHigh));
    addAxis(sum, theta, z.low, z.high, vec4(z.openLow), vec4(z.openHigh));
    return sum;
}

/// What a cell's step found, for the notes of its tile.
struct Found {
    bool awake, warm, evaporating;
};

/// The step of one cell. Nothing happens in an empty cell or where the temperature is held.
void advance(int cell, int otherHalf, uint entry, float theta, float metalFlow, float wallFlow, float largest,
             float openAxes, float elapsed, inout Found found) {
    if (theta < 0.0) {
        cellTheta[otherHalf] = theta;
        return;
    }
    const float dx = metal.spacing;
    const vec2 power = dx * vec2(metalFlow, wallFlow);
    const uint slot = entry - 1u;
    const vec4 h = texelFetch(heatTexels, int(slot));
    const float temperature = thermalState(h.x).x;
    const float losing = surfaceLoss(temperature, sqrt(openAxes) * dx * dx);
    const float lost = losing * elapsed; // may be due for several steps at once
    book(cell, power.y * heatBlock.timeStep, lost);
    const Heated heated = addHeat(slot, h, temperature, (power.x + power.y) * heatBlock.timeStep - lost, elapsed);
    cellTheta[otherHalf] = heated.theta;
    writePhase(slot, cell, otherHalf, heated.enthalpy);
    const bool losesMuch = abs(losing) * heatBlock.timeStep > heatBlock.wakingLoss;
    found.awake = found.awake || largest > heatBlock.wakingThetaDifference || losesMuch;
    found.warm = found.warm || (losing != 0.0 && abs(temperature - heatBlock.ambient) > heatBlock.warmAboveAmbient);
#ifdef EVAPORATION
    found.evaporating = found.evaporating || evaporates(heated.temperature);
#endif
}

void main() {
    const int tile = int(texelFetch(listTexels, int(gl_WorkGroupID.x)).x);
    const int row = int(gl_LocalInvocationIndex);
    const int cell = tile * TILE_CELLS + TILE_EDGE * row;
    const int stamp = stampOf(tile);
    const int base = thetaBase(stamp, tile);
    const int other = thetaBase(stamp ^ TILE_HALF, tile) + TILE_EDGE * row;
    const vec4 theta = rowOf(base, row);
    const RowInflow f = inflowOfRow(tile, base, row, theta);
    const uvec4 entry = texelFetch(latticeRows, cell / TILE_EDGE);
    const float elapsed = elapsedOf(tile);
    Found found = Found(false, false, false);
#define ADVANCE(C, I)                                                                                                  \
    advance(cell + I, other + I, entry.C, theta.C, f.metal_.C, f.walls.C, f.largest.C, f.openAxes.C, elapsed, found)
    ADVANCE(x, 0);
    ADVANCE(y, 1);
    ADVANCE(z, 2);
    ADVANCE(w, 3);
#undef ADVANCE
    const TileNotes notes = notesOf(tile);
    if (found.awake) noteActivity(tile, notes);
    const int now = heatBlock.stepNumber;
    if (found.warm && now - notes.lastWarm >= TILE_NOTE_INTERVAL) tiles[tile].lastWarm = now;
#ifdef EVAPORATION
    if (found.evaporating && now - notes.lastEvaporating >= TILE_NOTE_INTERVAL) tiles[tile].lastEvaporating = now;
#endif
}
