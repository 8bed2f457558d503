// Buffers and small functions that every heat pass uses. Included after the #version line.
#include "shared/heat.h"
#include "metal/state.glsl"

layout(std140, binding = HEAT_BLOCK) uniform Heat { HeatBlock heatBlock; };

layout(std430, binding = HEAT_CELL_THETA) restrict buffer CellTheta { float cellTheta[]; };
layout(std430, binding = HEAT_CELL_WEIGHT) restrict buffer CellWeights { float cellWeight[]; };
layout(std430, binding = HEAT_TILES) restrict buffer Tiles { HeatTile tiles[]; };
layout(std430, binding = HEAT_TILE_STAMPS) restrict buffer TileStamps { int tileStamp[]; };

// What a pass only reads, it reads here.
layout(binding = HEAT_TEXELS_TABLE) uniform samplerBuffer table;
layout(binding = HEAT_TEXELS_THETA) uniform samplerBuffer thetaTexels;
layout(binding = HEAT_TEXELS_WEIGHT) uniform samplerBuffer weightTexels;
layout(binding = HEAT_TEXELS_STAMPS) uniform isamplerBuffer stampTexels;
layout(binding = HEAT_TEXELS_TILES) uniform isamplerBuffer tileTexels;
layout(binding = HEAT_TEXELS_LISTS) uniform usamplerBuffer listTexels;
layout(binding = HEAT_TEXELS_LATTICE) uniform usamplerBuffer latticeTexels;
layout(binding = HEAT_TEXELS_HEATS) uniform samplerBuffer heatTexels;
layout(binding = HEAT_TEXELS_POSITIONS) uniform samplerBuffer positionTexels;
layout(binding = HEAT_TEXELS_PHASES) uniform usamplerBuffer phaseTexels;

// The Kirchhoff variable of a cell is negative where no particle sits, and more negative for one whose temperature is held.
const float kEmpty = -1.0;
bool isEmpty(float theta) { return theta == kEmpty; }
bool isHeld(float theta) { return theta < -1.5; }
float markHeld(float theta) { return -2.0 - theta; } // also the way back

/// Temperature (x, K) and Kirchhoff variable (y, W/m) at an enthalpy.
vec2 thermalState(float enthalpy) {
    vec4 start = heatBlock.tableStart;
    vec4 scale = heatBlock.tableScale;
    bool solid = enthalpy < start.y;
    bool mushy = enthalpy < start.z;
    int row = solid ? 0 : mushy ? HEAT_TABLE_ROW : 2 * HEAT_TABLE_ROW;
    float place = (enthalpy - (solid ? start.x : mushy ? start.y : start.z)) * (solid ? scale.x : mushy ? scale.y : scale.z);
    int i = int(clamp(place, 0.0, float(HEAT_TABLE_STEPS - 1)));
    vec4 samples = texelFetch(table, row + i);
    return samples.xy + (place - float(i)) * (samples.zw - samples.xy);
}

float liquidFraction(float enthalpy) {
    float range = metal.liquidusEnthalpy - metal.solidusEnthalpy;
    return range > 0.0 ? clamp((enthalpy - metal.solidusEnthalpy) / range, 0.0, 1.0) : float(enthalpy >= metal.liquidusEnthalpy);
}

int stampOf(int tile) { return texelFetch(stampTexels, tile).x; }
ivec4 notesOf(int tile) { return texelFetch(tileTexels, 2 * tile); } // lastNeed, lastLoose, lastWarm, lastHot
float sinceOf(int tile) { return intBitsToFloat(texelFetch(tileTexels, 2 * tile + 1).x); }
bool tookPart(int stamp, int stepNumber) { return (stamp >> TILE_STEP_SHIFT) == stepNumber; }

/// Where theta of a tile's cell 0 stands during the step that its stamp is of.
int thetaBase(int stamp, int tile) { return ((stamp & TILE_HALF) * heatBlock.step.w + tile) * TILE_CELLS; }

/// Where theta of a cell stands during its tile's step.
int thetaPlace(int cell) { return (stampOf(cell / TILE_CELLS) & TILE_HALF) * heatBlock.step.w * TILE_CELLS + cell; }

/// Whether a source may reach a tile.
bool reaches(HeatSourceData s, ivec3 tilePlace) {
    return all(greaterThanEqual(tilePlace, s.lowTile.xyz)) && all(lessThan(tilePlace, s.lowTile.xyz + s.tileCount.xyz));
}

/// Cells beside a cell along x, y and z, on the low and on the high side. Written out without loops over axes: drivers that
/// run on the CPU keep arrays that are indexed at run time in memory.
struct Beside {
    ivec3 low, high;       // from the cell on; 0 beyond the lattice's end, where the cell stands for its neighbour
    bvec3 edgeLow, edgeHigh; // the neighbour is in another tile
    bvec3 endLow, endHigh; // there is none: beyond the lattice's end
};

Beside cellsBeside(ivec3 tilePlace, int inside) {
    Beside b;
    ivec3 at = insideCoordinate(inside);
    ivec3 inner = ivec3(1, 4, 16);
    ivec3 outer = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y) * TILE_CELLS - (TILE_EDGE - 1) * inner;
    b.edgeLow = equal(at, ivec3(0));
    b.edgeHigh = equal(at, ivec3(TILE_EDGE - 1));
    b.endLow = bvec3(ivec3(b.edgeLow) & ivec3(equal(tilePlace, ivec3(0))));
    b.endHigh = bvec3(ivec3(b.edgeHigh) & ivec3(equal(tilePlace, metal.tiles - 1)));
    b.low = -mix(mix(inner, outer, b.edgeLow), ivec3(0), b.endLow);
    b.high = mix(mix(inner, outer, b.edgeHigh), ivec3(0), b.endHigh);
    return b;
}

/// What stands there.
struct Neighbours {
    vec3 low, high;          // Kirchhoff variable
    bvec3 openLow, openHigh; // the neighbour's tile takes part in this step, so that both sides count the flow
};

/// The six neighbours of cell `inside` of `tile`, which takes part in this step with `stamp`.
Neighbours readNeighbours(int tile, int stamp, int inside, Beside b) {
    Neighbours n;
    ivec3 tileStride = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y);
    // A cell has at most one tile beside it along an axis.
    ivec3 beside = ivec3(tile) + mix(ivec3(0), tileStride, b.edgeHigh) - mix(ivec3(0), tileStride, b.edgeLow);
    beside = mix(beside, ivec3(tile), bvec3(ivec3(b.endLow) | ivec3(b.endHigh)));
    ivec3 stamps = ivec3(stampOf(beside.x), stampOf(beside.y), stampOf(beside.z));
    bvec3 open = equal(stamps >> TILE_STEP_SHIFT, ivec3(heatBlock.step.x));
    // A resting tile that was plain in its last step has had its halves changed, and its bit taken away, by then.
    ivec3 own = ivec3(thetaBase(stamp, tile) + inside);
    ivec3 shift = ((stamps & TILE_HALF) - (stamp & TILE_HALF)) * (heatBlock.step.w * TILE_CELLS);
    ivec3 low = own + b.low + mix(ivec3(0), shift, b.edgeLow);
    ivec3 high = own + b.high + mix(ivec3(0), shift, b.edgeHigh);
    n.low = vec3(texelFetch(thetaTexels, low.x).x, texelFetch(thetaTexels, low.y).x, texelFetch(thetaTexels, low.z).x);
    n.high = vec3(texelFetch(thetaTexels, high.x).x, texelFetch(thetaTexels, high.y).x, texelFetch(thetaTexels, high.z).x);
    n.low = mix(n.low, vec3(kEmpty), b.endLow);
    n.high = mix(n.high, vec3(kEmpty), b.endHigh);
    n.openLow = bvec3(ivec3(not(b.edgeLow)) | ivec3(open));
    n.openHigh = bvec3(ivec3(not(b.edgeHigh)) | ivec3(open));
    return n;
}

/// Power into a cell from each side over one spacing (W/m) as conduction gives it: two cells exchange dx (theta_j - theta_i),
/// k A/dx with k inside theta. A held neighbour stands for a wall at the face between the two, half as far away.
struct Inflow {
    vec3 low, high;
    bvec3 wallLow, wallHigh;
};

Inflow inflowOf(Neighbours n, float theta) {
    Inflow f;
    f.wallLow = lessThan(n.low, vec3(-1.5));
    f.wallHigh = lessThan(n.high, vec3(-1.5));
    // Where nothing sits the difference is 0.
    f.low = mix(n.low - theta, 2.0 * (-2.0 - n.low - theta), f.wallLow) * (1.0 - vec3(equal(n.low, vec3(kEmpty))));
    f.high = mix(n.high - theta, 2.0 * (-2.0 - n.high - theta), f.wallHigh) * (1.0 - vec3(equal(n.high, vec3(kEmpty))));
    return f;
}

/// Whether the differences to the neighbours are worth another step.
bool keepsAwake(Inflow f) {
    vec3 largest = max(abs(f.low), abs(f.high));
    return max(max(largest.x, largest.y), largest.z) > heatBlock.waking.x;
}

/// Watts from metal (x) and from walls (y). A face is counted when both its tiles take part, so what one side gives the other
/// gets; a wall's heat comes from outside the metal and needs no open partner.
vec2 powerOf(Inflow f, Neighbours n) {
    vec3 walls = f.low * vec3(f.wallLow) + f.high * vec3(f.wallHigh);
    vec3 metal_ = f.low * vec3(n.openLow) * vec3(not(f.wallLow)) + f.high * vec3(n.openHigh) * vec3(not(f.wallHigh));
    return metal.spacing * vec2(metal_.x + metal_.y + metal_.z, walls.x + walls.y + walls.z);
}

/// How full a cell with that weight is, 0 .. 1. Steep, so that the unevenness inside liquid metal makes no surface.
float fullness(float weight) { return clamp((weight - 0.15) / 0.5, 0.0, 1.0); }

/// Weights of the neighbours beside a cell.
struct Weights {
    vec3 low, high;
};

Weights readWeights(int cell, Beside b) {
    Weights w;
    ivec3 low = ivec3(cell) + b.low;
    ivec3 high = ivec3(cell) + b.high;
    w.low = vec3(texelFetch(weightTexels, low.x).x, texelFetch(weightTexels, low.y).x, texelFetch(weightTexels, low.z).x);
    w.high = vec3(texelFetch(weightTexels, high.x).x, texelFetch(weightTexels, high.y).x, texelFetch(weightTexels, high.z).x);
    w.low = mix(w.low, vec3(0), b.endLow);
    w.high = mix(w.high, vec3(0), b.endHigh);
    return w;
}

/// Free surface of a cell that loose metal may share: xyz its outward normal (unit length, or zero where both sides are open
/// alike), w its area in m². Over each face the step down in fullness counts, so that the steps through a surface anywhere
/// between cells add up to its area.
vec4 freeSurface(float weight, Weights w) {
    float own = fullness(weight);
    vec3 low = max(vec3(0), own - vec3(fullness(w.low.x), fullness(w.low.y), fullness(w.low.z)));
    vec3 high = max(vec3(0), own - vec3(fullness(w.high.x), fullness(w.high.y), fullness(w.high.z)));
    vec3 normal = high - low;
    float size = length(normal);
    float area = length(high + low) * metal.spacing * metal.spacing;
    return vec4(size > 0.0 ? normal / size : vec3(0), area);
}

/// Free surface in m² of a cell of the lattice alone. The vector sum over the open faces is exact on planes along the lattice
/// and on even slopes.
float freeArea(Neighbours n) {
    vec3 open = vec3(equal(n.low, vec3(kEmpty))) + vec3(equal(n.high, vec3(kEmpty)));
    return length(open) * metal.spacing * metal.spacing;
}

/// Notes that something happened in a tile whose notes at the start of the pass were `notes`.
void noteNeed(int tile, ivec4 notes) {
    if (heatBlock.step.x - notes.x >= TILE_NOTE) tiles[tile].lastNeed = heatBlock.step.x;
}
