// Buffers and small functions that every heat pass uses. Included after the #version line.
#include "shared/heat.h"
#include "shared/metal.h"

layout(std140, binding = METAL_BLOCK) uniform Metal { MetalBlock metal; };
layout(std140, binding = HEAT_BLOCK) uniform Heat { HeatBlock heatBlock; };

layout(std430, binding = METAL_POSITION) restrict buffer Positions { vec4 position[]; };
layout(std430, binding = METAL_HEAT) restrict buffer Heats { vec4 heat[]; };
layout(std430, binding = METAL_PHASE) restrict buffer Phases { uint phase[]; };
layout(std430, binding = METAL_LATTICE) restrict buffer Lattice { uint lattice[]; };
layout(binding = HEAT_TEXELS_TABLE) uniform samplerBuffer table;
layout(std430, binding = HEAT_CELL_THETA) restrict buffer CellTheta { float cellTheta[]; };
layout(std430, binding = HEAT_TILES) restrict buffer Tiles { HeatTile tiles[]; };
layout(std430, binding = HEAT_TILE_STAMPS) restrict buffer TileStamps { int tileStamp[]; }; // last step each took part in

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
    float range = metal.melting.y - metal.melting.x;
    return range > 0.0 ? clamp((enthalpy - metal.melting.x) / range, 0.0, 1.0) : float(enthalpy >= metal.melting.y);
}

ivec3 tileCoordinate(int tile) {
    ivec3 size = metal.tiles.xyz;
    return ivec3(tile % size.x, tile / size.x % size.y, tile / (size.x * size.y));
}

int tileIndex(ivec3 tile) { return (tile.z * metal.tiles.y + tile.y) * metal.tiles.x + tile.x; }

ivec3 insideCoordinate(int inside) {
    return ivec3(inside & 3, (inside >> 2) & 3, inside >> 4); // TILE_EDGE is 4
}

vec3 cellCentre(ivec3 cell) { return metal.origin.xyz + (vec3(cell) + 0.5) * metal.origin.w; }

/// What stands beside a cell along x, y and z, on the low and on the high side.
struct Neighbours {
    vec3 low, high;         // as in the cell buffer
    bvec3 openLow, openHigh; // the neighbour's tile takes part in this step, so that both sides count the flow
};

/// The six neighbours of cell `inside` of `tile`. Written out without loops over axes: drivers that run on the CPU keep
/// arrays that are indexed at run time in memory.
Neighbours readNeighbours(int tile, ivec3 tilePlace, int inside, int stepNumber) {
    Neighbours n;
    ivec3 at = insideCoordinate(inside);
    int cell = tile * TILE_CELLS + inside;
    ivec3 tileStride = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y);
    ivec3 inner = ivec3(1, 4, 16);
    ivec3 outer = tileStride * TILE_CELLS - (TILE_EDGE - 1) * inner;
    bvec3 edgeLow = equal(at, ivec3(0));
    bvec3 edgeHigh = equal(at, ivec3(TILE_EDGE - 1));
    // Beyond the lattice's end the cell reads itself, and the result is replaced.
    bvec3 endLow = bvec3(ivec3(edgeLow) * ivec3(equal(tilePlace, ivec3(0))));
    bvec3 endHigh = bvec3(ivec3(edgeHigh) * ivec3(equal(tilePlace, metal.tiles.xyz - 1)));
    ivec3 low = ivec3(cell) - mix(mix(inner, outer, edgeLow), ivec3(0), endLow);
    ivec3 high = ivec3(cell) + mix(mix(inner, outer, edgeHigh), ivec3(0), endHigh);
    n.low = mix(vec3(cellTheta[low.x], cellTheta[low.y], cellTheta[low.z]), vec3(kEmpty), endLow);
    n.high = mix(vec3(cellTheta[high.x], cellTheta[high.y], cellTheta[high.z]), vec3(kEmpty), endHigh);
    // These six are the same for all cells of the tile.
    ivec3 tileLow = max(ivec3(tile) - tileStride, ivec3(0));
    ivec3 tileHigh = min(ivec3(tile) + tileStride, ivec3(heatBlock.step.w - 1));
    ivec3 stampLow = ivec3(tileStamp[tileLow.x], tileStamp[tileLow.y], tileStamp[tileLow.z]);
    ivec3 stampHigh = ivec3(tileStamp[tileHigh.x], tileStamp[tileHigh.y], tileStamp[tileHigh.z]);
    n.openLow = bvec3(ivec3(not(edgeLow)) | ivec3(equal(stampLow, ivec3(stepNumber))));
    n.openHigh = bvec3(ivec3(not(edgeHigh)) | ivec3(equal(stampHigh, ivec3(stepNumber))));
    return n;
}

#ifdef MIXED
layout(std430, binding = HEAT_CELL_WEIGHT) restrict buffer CellWeights { float cellWeight[]; };

/// How full a cell with that weight is, 0 .. 1. Steep, so that the unevenness inside liquid metal makes no surface.
float fullness(float weight) { return clamp((weight - 0.15) / 0.5, 0.0, 1.0); }

/// Weights of the neighbours beside their Kirchhoff variables.
void readWeights(int tile, ivec3 tilePlace, int inside, out vec3 low, out vec3 high) {
    ivec3 at = insideCoordinate(inside);
    int cell = tile * TILE_CELLS + inside;
    ivec3 tileStride = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y);
    ivec3 inner = ivec3(1, 4, 16);
    ivec3 outer = tileStride * TILE_CELLS - (TILE_EDGE - 1) * inner;
    bvec3 edgeLow = equal(at, ivec3(0));
    bvec3 edgeHigh = equal(at, ivec3(TILE_EDGE - 1));
    bvec3 endLow = bvec3(ivec3(edgeLow) * ivec3(equal(tilePlace, ivec3(0))));
    bvec3 endHigh = bvec3(ivec3(edgeHigh) * ivec3(equal(tilePlace, metal.tiles.xyz - 1)));
    ivec3 lowCell = ivec3(cell) - mix(mix(inner, outer, edgeLow), ivec3(0), endLow);
    ivec3 highCell = ivec3(cell) + mix(mix(inner, outer, edgeHigh), ivec3(0), endHigh);
    low = mix(vec3(cellWeight[lowCell.x], cellWeight[lowCell.y], cellWeight[lowCell.z]), vec3(0), endLow);
    high = mix(vec3(cellWeight[highCell.x], cellWeight[highCell.y], cellWeight[highCell.z]), vec3(0), endHigh);
}

/// Free surface of a cell that loose metal may share: over each face the step down in fullness counts, so that the steps
/// through a surface anywhere between cells add up to its area.
vec4 freeSurface(float weight, vec3 weightLow, vec3 weightHigh) {
    float own = fullness(weight);
    vec3 low = max(vec3(0), own - vec3(fullness(weightLow.x), fullness(weightLow.y), fullness(weightLow.z)));
    vec3 high = max(vec3(0), own - vec3(fullness(weightHigh.x), fullness(weightHigh.y), fullness(weightHigh.z)));
    vec3 normal = high - low;
    float size = length(normal);
    float area = length(high + low) * metal.origin.w * metal.origin.w;
    return vec4(size > 0.0 ? normal / size : vec3(0), area);
}
#endif

vec3 emptyMask(vec3 theta) { return vec3(equal(theta, vec3(kEmpty))); }

/// Free surface of a cell: xyz its outward normal (unit length, or zero where both sides are open alike), w its area in m².
/// The vector sum over the open faces is exact on planes along the lattice and on even slopes.
vec4 freeSurface(Neighbours n) {
    vec3 low = emptyMask(n.low);
    vec3 high = emptyMask(n.high);
    vec3 normal = high - low;
    float size = length(normal);
    float area = length(high + low) * metal.origin.w * metal.origin.w;
    return vec4(size > 0.0 ? normal / size : vec3(0), area);
}
