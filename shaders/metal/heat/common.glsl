// Buffers and small functions that every heat pass uses. Included after the #version line.
#include "shared/heat.h"
#define METAL_WITHOUT_VELOCITIES
#include "metal/state.glsl"

layout(std140, binding = HEAT_BLOCK) uniform Heat { HeatBlock heatBlock; };

layout(std430, binding = HEAT_CELL_THETA) restrict buffer CellTheta { float cellTheta[]; };
layout(std430, binding = HEAT_CELL_WEIGHT) restrict buffer CellWeights { uint cellWeight[]; };
layout(std430, binding = HEAT_TILES) restrict buffer Tiles { HeatTile tiles[]; };
layout(std430, binding = HEAT_TILE_STAMPS) restrict buffer TileStamps { int tileStamp[]; };

// Buffers that a pass only reads.
layout(binding = HEAT_TEXELS_TABLE) uniform samplerBuffer table;
layout(binding = HEAT_TEXELS_THETA) uniform samplerBuffer thetaTexels;
layout(binding = HEAT_TEXELS_WEIGHT) uniform usamplerBuffer weightTexels;
layout(binding = HEAT_TEXELS_STAMPS) uniform isamplerBuffer stampTexels;
layout(binding = HEAT_TEXELS_TILES) uniform isamplerBuffer tileTexels;
layout(binding = HEAT_TEXELS_LISTS) uniform usamplerBuffer listTexels;
layout(binding = HEAT_TEXELS_LATTICE) uniform usamplerBuffer latticeTexels;
layout(binding = HEAT_TEXELS_HEATS) uniform samplerBuffer heatTexels;
layout(binding = HEAT_TEXELS_POSITIONS) uniform samplerBuffer positionTexels;
layout(binding = HEAT_TEXELS_PHASES) uniform usamplerBuffer phaseTexels;

// The Kirchhoff variable of a cell is negative if no particle sits there, and more negative for one of fixed
// temperature.
const float kEmpty = -1.0;
bool isEmpty(float theta) { return theta == kEmpty; }
bool isHeld(float theta) { return theta < -1.5; }
float markHeld(float theta) { return -2.0 - theta; } // its own inverse

/// Temperature (x, K) and Kirchhoff variable (y, W/m) at an enthalpy.
vec2 thermalState(float enthalpy) {
    // The components are solid, mushy and liquid.
    vec3 start = heatBlock.tableStart;
    vec3 scale = heatBlock.tableScale;
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

// Offsets of the lists in HEAT_LISTS, behind that of the mixed tiles.
int offLatticeTilesBegin() { return heatBlock.tileCount; }
int metalTilesBegin() { return 2 * heatBlock.tileCount; }
int offLatticeSlotsBegin() { return 3 * heatBlock.tileCount; }

int stampOf(int tile) { return texelFetch(stampTexels, tile).x; }
/// The first half of a HeatTile.
struct TileNotes {
    int lastActive, lastOffLattice, lastWarm, lastEvaporating;
};

TileNotes notesOf(int tile) {
    const ivec4 notes = texelFetch(tileTexels, 2 * tile);
    return TileNotes(notes.x, notes.y, notes.z, notes.w);
}

float elapsedOf(int tile) { return intBitsToFloat(texelFetch(tileTexels, 2 * tile + 1).x); }
/// HeatTile::rows.
uint rowBitsOf(int tile) { return uint(texelFetch(tileTexels, 2 * tile + 1).z); }
bool tookPart(int stamp, int stepNumber) { return (stamp >> TILE_STEP_SHIFT) == stepNumber; }

/// Index of theta of a tile's cell 0 during the step of the stamp.
int thetaBase(int stamp, int tile) { return ((stamp & TILE_HALF) * heatBlock.tileCount + tile) * TILE_CELLS; }

/// Number of particles that share a cell.
float weightOf(int cell) { return float(texelFetch(weightTexels, cell).x) / float(SHARE_UNIT); }

/// Index of theta of a cell during its tile's step.
int thetaIndex(int cell) { return (stampOf(cell / TILE_CELLS) & TILE_HALF) * heatBlock.tileCount * TILE_CELLS + cell; }

/// True if a source may reach a tile.
bool reaches(HeatSourceData s, ivec3 tilePlace) {
    return all(greaterThanEqual(tilePlace, s.firstTile)) && all(lessThan(tilePlace, s.firstTile + s.tileExtent));
}

/// The first source from number `i` on that may reach a tile; the number of sources if none does. For the heads of
/// loops. SYNCHRONOUS_DRIVER: it skips a loop that no invocation enters, but no branch.
int nextReaching(ivec3 tilePlace, int i) {
    while (i < heatBlock.sourceCount && !reaches(heatBlock.sources[i], tilePlace)) ++i;
    return i;
}

/// Tile number `group` of the box that the source reaches.
ivec3 sourceTile(HeatSourceData s, int group) {
    return s.firstTile +
           ivec3(group % s.tileExtent.x, group / s.tileExtent.x % s.tileExtent.y, group / (s.tileExtent.x * s.tileExtent.y));
}

/// Records activity in a tile whose notes at the start of the pass were `notes`.
void noteActivity(int tile, TileNotes notes) {
    if (heatBlock.stepNumber - notes.lastActive >= TILE_NOTE_INTERVAL) tiles[tile].lastActive = heatBlock.stepNumber;
}
