// Definitions that the heat passes share with C++: parameters of a step, sources, bindings.
#ifndef MELTPOOL_SHARED_HEAT_H
#define MELTPOOL_SHARED_HEAT_H

#include "glsl_types.h"
#include "heat_source.h"
#include "heat_table.h"
#include "metal.h"

#define HEAT_BLOCK 1 // uniform buffer

// Storage buffers of the heat passes besides the particle buffers. A pass binds only the buffers that it reads: one
// binding may have another meaning in another pass.
#define HEAT_CHANGES 6 // the metal's list of slots whose phase changed
#define HEAT_CELL_THETA                                                                                                \
    7 // float a cell, twice: Kirchhoff variable of the metal there, negative in an empty cell; see TILE_HALF
#define HEAT_CELL_SUMS                                                                                                 \
    1 // uint a cell (replaces the velocities): sum of weight times theta, in HeatBlock.thetaUnit; 0 between steps
#define HEAT_CELL_POWER 1 // this memory after averaging: float a cell of mixed tiles, net power into it, W
#define HEAT_CELL_RANGE                                                                                                \
    8 // uvec2 a cell that metal off the lattice shares: see CellRange in cell_range.glsl; 0 between steps
#define HEAT_TILES 9      // HeatTile a tile
// uint: three lists of tiles, one after the other: the mixed ones, with HEAT_REACHED added if a source may reach one,
// those with metal off the lattice, and those that ever held metal; then the list of slots off it.
#define HEAT_LISTS 10
#define HEAT_REACHED 0x80000000u
#define HEAT_CONTROL 11   // HeatControl
#define HEAT_SOURCE_SUMS 12 // float: sum of weights of each source
#define HEAT_LEDGER 13      // vec4 a cell, then a particle: joules gained, their residual, joules lost, their residual
#define HEAT_TILE_STAMPS 14 // int a tile: TILE_... below
#define HEAT_CELL_WEIGHT 5  // uint a cell (replaces the counters): number of particles that share it, in 1/SHARE_UNIT
#define HEAT_FROZEN_AT 15     // the metal's times of freezing
#define HEAT_KNOWN_CELLS 12   // uint a slot: recorded cell + 1, or HEAT_OFF_LATTICE (not with the sums of sources)
#define HEAT_LISTED_ROWS 12   // uint (not with either of them): see HeatControl
#define HEAT_OFF_LATTICE 0xffffffffu // the slot is in the list of slots off the lattice

// Buffers that are read as textures. SYNCHRONOUS_DRIVER: it fetches texels several times faster than storage.
#define HEAT_TEXELS_TABLE 0 // samples of temperature and theta, each with the next one beside it
#define HEAT_TEXELS_THETA 1
#define HEAT_TEXELS_WEIGHT 2
#define HEAT_TEXELS_STAMPS 3
#define HEAT_TEXELS_TILES 4 // two texels a tile
#define HEAT_TEXELS_LISTS 5
#define HEAT_TEXELS_LATTICE 6
#define HEAT_TEXELS_HEATS 7
#define HEAT_TEXELS_POSITIONS 8
#define HEAT_TEXELS_PHASES 9
#define HEAT_TEXELS_THETA_ROWS 10   // four cells along x a texel
#define HEAT_TEXELS_LATTICE_ROWS 11 // likewise
#define HEAT_TEXELS_LISTED_ROWS 12

#define HEAT_SOURCES 4

// Steps without activity in a tile and its neighbours after which it sleeps.
#define TILE_AWAKE_STEPS 8
// Steps after which activity in a tile is recorded again.
#define TILE_NOTE_INTERVAL 4
// Steps after which a sleeping tile with a warm surface loses heat, for all the time since the last loss.
#define TILE_LOSS_INTERVAL 16

// A tile's stamp: its last step in the upper bits, and three bits below. A plain tile's step reads theta from one half
// of the buffer, as its neighbours do, and writes the other half; the next step changes halves. A mixed tile makes its
// step in place, after all have read, and stores its free surface in m² in the other half during the step.
#define TILE_STEP_SHIFT 3
#define TILE_PLAIN 2                // it made its last step as a plain tile: theta is now in the other half
#define TILE_SHARED 4               // metal off the lattice was in it
#define TILE_HALF 1                 // half of theta during that step
#define TILE_NO_METAL (-0x40000000) // a tile that never held metal: takes part only when metal off the lattice comes
#define TILE_UNLISTED (-0x40000000) // value of HeatTile.lastOffLattice: not in the list of tiles that ever held metal

// Rows of four cells along x in a tile. A row that never held metal of the lattice, and that none off it shares, is
// empty in both halves of theta, and no step visits it.
#define TILE_ROWS (TILE_CELLS / TILE_EDGE)

// Unit of the weight that a particle off the lattice distributes over the eight cells around it: sums of integers do
// not depend on their order.
#define SHARE_UNIT 65536u

#ifdef __cplusplus
namespace meltpool {
#endif

struct HeatSourceData {
    vec3 position; // m
    int kind;      // SOURCE_...
    vec3 axis;     // unit vector into the metal
    float power;   // W
    vec3 travel;   // unit vector of travel
    float size;    // radius, sigma or front half-axis, m
    // The other half-axes of the ellipsoid in m, and twice the front's share of the power.
    float halfWidth;
    float depth;
    float rear;
    float frontFraction;
    ivec3 firstTile; // first tile that the source can reach
    int unused;
    ivec3 tileExtent;     // tiles it can reach along each axis,
    int tileCount;        // and in all
    float tipTemperature; // K
    float tipConductance; // W/(m² K)
    // The heated stretch of the Gaussian's axis, and the sum of weights at which it gives its whole power.
    float before;     // m, from the torch to the position: metal farther back is behind the torch
    float beyond;     // m, from the position to where the first surface blocks the heat from others; see source.glsl
    float fullWeight; // m²; 0: any metal gets the whole power
    float reserved0;
    float reserved1;
    float reserved2;
};

struct HeatBlock {
    float timeStep;              // s
    float convection;            // W/(m² K)
    float ambient;               // K
    float radiation;             // emissivity times Stefan-Boltzmann, W/(m² K⁴)
    float boilingPoint;          // K; 0: no evaporation
    float evaporationExponent;   // Lv M/R, K
    float evaporationFactor;     // factor of the flux, W K^(1/2)/m²
    float liquidSpecificHeat;    // J/(kg K)
    float wakingThetaDifference; // difference between neighbours, W/m, that keeps a tile awake
    float warmAboveAmbient;      // K off ambient from which a surface loses heat also in a sleeping tile
    float wakingLoss;            // J of a particle in a step, through the surface, that keeps a tile awake
    uint endTime;                // time at the end of the step, µs; may wrap
    int stepNumber;
    int sourceCount;
    int meltLeavesLattice;         // 1: melted particles leave the lattice
    int tileCount;                 // tiles of the lattice
    vec3 tableStart;               // first enthalpy of the solid, mushy and liquid part of the table, J/kg
    float thetaUnit;               // W/m of theta per unit of its integer sum
    vec3 tableScale;               // samples per J/kg in the three parts
    float weldingTableHeight;      // m along its normal, height of the table that fallen metal rests on
    vec3 weldingTableNormal;       // unit vector out of the table
    float weldingTableConductance; // conductance to metal that rests on it, W/(m² K)
    float evaporatesFrom;          // K
    float time;                    // s since the start, at the end of the step
    float liquidTheta;             // W/m, of metal at its liquidus
    int mostTurns;     // of Newton's method for evaporation. SYNCHRONOUS_DRIVER: it runs all turns of a loop whose
                       // number it knows; otherwise those that an invocation needs
    vec3 stirringLess; // share by which stirred liquid conducts less along each axis, for directed mixing
    float reservedWay;
    HeatSourceData sources[HEAT_SOURCES];
};

/// Lists of a step: groups of their indirect dispatches in x, and the number of entries in w. Plain tiles hold metal on
/// the lattice that conducts and loses heat to the air, and no more; mixed ones hold metal off the lattice, or a
/// neighbour does, a source may reach them, or their metal evaporates. A row of cells is listed as its tile's number
/// times TILE_ROWS plus its own in the tile. Those of plain tiles come first, then those of mixed tiles that a source
/// may reach; those of the other mixed tiles are at the end of the list, from the last entry back.
struct HeatControl {
    uvec4 mixedTiles;       // TILE_ROWS invocations each; a group at least
    uvec4 plainRows;        // an invocation each
    uvec4 reachedRows;      // TILE_EDGE invocations each,
    uvec4 unreachedRows;    // likewise,
    uvec4 mixedRows;        // and these two together; w: unused
    uvec4 offLatticeTiles;  // metal off the lattice in the tile: a group each; w: unused
    uvec3 offLatticeGroups; // groups over the list of slots off the lattice
    uint offLatticeCount;   // slots in that list
    uvec3 metalTileGroups;  // groups over the list of tiles that ever held metal, which only grows
    uint metalTileCount;    // tiles in it
};

struct HeatTile {
    int lastActive;      // number of the last step with activity, to within TILE_NOTE_INTERVAL
    int lastOffLattice;  // number of the last step in which metal off the lattice was in it
    int lastWarm;        // number of the last step in which its surface was off ambient, to within TILE_NOTE_INTERVAL
    int lastEvaporating; // number of the last step in which metal evaporated in it, to within TILE_NOTE_INTERVAL
    float elapsed;       // simulated time since it last took part, its latest step included, s
    uint endTime;        // end of that step, µs
    uint rows;           // a bit for each row that held metal of the lattice at its last whole reading
    uint reserved;
};

#ifdef __cplusplus
static_assert(sizeof(HeatSourceData) == 128);
static_assert(sizeof(HeatBlock) == 144 + HEAT_SOURCES * 128);
static_assert(sizeof(HeatControl) == 128);
static_assert(sizeof(HeatTile) == 32);
} // namespace meltpool
#endif

#endif
