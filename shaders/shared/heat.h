// What the heat passes share with C++: parameters of a step, sources, bindings.
#ifndef MELTPOOL_SHARED_HEAT_H
#define MELTPOOL_SHARED_HEAT_H

#include "glsl_types.h"
#include "heat_table.h"

#define HEAT_BLOCK 1 // uniform buffer

// Storage buffers of the heat passes beside the particle buffers. A pass binds only what it reads: the same place may
// mean something else in another pass.
#define HEAT_CHANGES 6    // the metal's list of slots whose phase changed
#define HEAT_CELL_THETA 7 // float a cell, twice: Kirchhoff variable of what is there, negative where nothing is
#define HEAT_CELL_POWER 8 // float a cell: net power into it, W; of mixed tiles
#define HEAT_TILES 9      // HeatTile a tile
#define HEAT_LISTS 10 // uint: three lists of tiles, one after the other, then the list of loose slots, which only grows
#define HEAT_CONTROL 11     // HeatControl
#define HEAT_PARTIAL 12     // float a source tile: sum of weights
#define HEAT_LEDGER 13      // vec4 a cell, then a particle: joules gained, their residual, joules lost, their residual
#define HEAT_TILE_STAMPS 14 // int a tile: TILE_... below
#define HEAT_CELL_AREA 15   // float a cell: free surface in m²; of mixed tiles
#define HEAT_CELL_WEIGHT                                                                                               \
    5                    // float a cell: how many particles share it (replaces the counters, which no heat pass needs)
#define HEAT_CELL_SUMS 1 // HeatSum a cell (replaces the velocities)
#define HEAT_HOMES 12 // uint a slot: cell + 1 that heat knows it to sit in, or HEAT_LOOSE (not beside the partial sums)
#define HEAT_LOOSE 0xffffffffu // it is in the list of loose slots

// Buffers that are read as textures: drivers that run on the CPU fetch texels several times faster than storage.
#define HEAT_TEXELS_TABLE 0 // samples of temperature and theta, and the next ones beside them
#define HEAT_TEXELS_THETA 1
#define HEAT_TEXELS_WEIGHT 2
#define HEAT_TEXELS_STAMPS 3
#define HEAT_TEXELS_TILES 4 // two texels a tile
#define HEAT_TEXELS_LISTS 5
#define HEAT_TEXELS_LATTICE 6
#define HEAT_TEXELS_HEATS 7
#define HEAT_TEXELS_POSITIONS 8
#define HEAT_TEXELS_PHASES 9
#define HEAT_TEXELS_THETA_ROWS 10 // four cells along x a texel
#define HEAT_TEXELS_LATTICE_ROWS 11 // likewise

#define HEAT_SOURCES 4

#define SOURCE_SPHERE 0    // volume, 1 - d²/R²
#define SOURCE_GAUSSIAN 1  // surface that faces it, exp(-r²/(2 sigma²)) around its axis
#define SOURCE_ELLIPSOID 2 // volume, Goldak's double ellipsoid
#define SOURCE_TIP 3 // surface within its radius, coefficient times temperature difference, power at most as stated

// A tile takes part as long as something happened in it or beside it within this many steps.
#define TILE_PATIENCE 8
// What happens in a tile is noted anew after so many steps.
#define TILE_NOTE 4
// A tile that does nothing but lose heat through its surface takes part every so many steps, for all the time since.
#define TILE_REST 16

// A tile's stamp: the last step it took part in above, and below two bits. A plain tile's step reads theta from one
// half of the buffer, as all that stand beside it do, and writes the other half; the next step changes halves. A mixed
// tile takes its step in place, when all have read.
#define TILE_STEP_SHIFT 2
#define TILE_PLAIN 2                // it took its last step as a plain tile: theta is in the other half by now
#define TILE_HALF 1                 // where theta was during that step
#define TILE_NO_METAL (-0x40000000) // a tile that never held any: it takes part only when loose metal comes

// Loose metal spreads over the eight cells around it; the sums are integers, so that their order does not matter.
#define LOOSE_UNIT 65536.0

#ifdef __cplusplus
namespace meltpool {
#endif

struct HeatSourceData {
    vec4 place;      // xyz m, w kind
    vec4 axis;       // xyz unit vector into the metal, w power in W
    vec4 ahead;      // xyz unit vector of travel, w radius, sigma or front half-axis in m
    vec4 shape;      // x half-width, y depth, z rear half-axis (m), w front fraction; tip: x temperature K, y W/(m² K)
    ivec4 lowTile;   // first tile it can reach, w first place in the partial sums
    ivec4 tileCount; // tiles it can reach along each axis, w their number
};

struct HeatBlock {
    vec4 time;        // x step in s, y convection in W/(m² K), z ambient in K, w emissivity times Stefan-Boltzmann
    vec4 evaporation; // x boiling point in K (0: none), y Lv M/R in K, z factor of the flux, w J/kg K⁻¹ of the liquid
    vec4 waking;      // x difference of theta between neighbours (W/m), z loss in J a step, that keep a tile awake;
                      // y K off ambient from which a surface has its turns
    uvec4 clock;      // x time at the end of the step in µs, which may wrap; yzw free
    ivec4 step;       // x number of the step, y number of sources, z 1: melted particles leave the lattice, w tiles
    vec4 tableStart;  // xyz first enthalpy of the solid, mushy and liquid piece of the table, J/kg
    vec4 tableScale;  // xyz samples per J/kg
    vec4 loose;       // x W/m of theta that one unit of its integer sum stands for, y free,
                      // z height of the table in m, w its conductance to metal that lies on it, W/(m² K)
    HeatSourceData sources[HEAT_SOURCES];
};

struct HeatSum {
    uint weight; // of loose particles, in 1/LOOSE_UNIT
    uint theta;  // weight times theta, in units of HeatBlock.loose.x
};

/// Groups of the indirect dispatches; the fourth number of each is free.
struct HeatControl {
    uvec4 plain; // tiles where metal on the lattice conducts and loses heat to the air, and no more
    uvec4 mixed; // tiles with loose metal in or beside them, under a source, or so hot that metal evaporates
    uvec4 sums;  // tiles with loose metal in them
    uvec4 loose; // x groups of loose particles, w their number
};

struct HeatTile {
    int lastNeed;  // number of the last step in which something happened, to within TILE_NOTE
    int lastLoose; // number of the last step in which loose metal was in it
    int lastWarm;  // number of the last step in which its surface was off ambient, to within TILE_NOTE
    int lastHot;   // number of the last step in which metal evaporated in it, to within TILE_NOTE
    float since;   // simulated time since it last took part, its latest step included, s
    uint upTo;     // time at the end of that step, µs
    uint reserved[2];
};

#ifdef __cplusplus
static_assert(sizeof(HeatSourceData) == 96);
static_assert(sizeof(HeatBlock) == 128 + HEAT_SOURCES * 96);
static_assert(sizeof(HeatControl) == 64);
static_assert(sizeof(HeatTile) == 32);
} // namespace meltpool
#endif

#endif
