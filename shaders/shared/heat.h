// What the heat passes share with C++: parameters of a step, sources, bindings.
#ifndef MELTPOOL_SHARED_HEAT_H
#define MELTPOOL_SHARED_HEAT_H

#include "glsl_types.h"
#include "heat_table.h"

#define HEAT_BLOCK 1 // uniform buffer

// Storage buffers of the heat passes beside the particle buffers.
#define HEAT_TABLE 6
#define HEAT_CELL_THETA 7  // float a cell: Kirchhoff variable of the particle there, negative where none is
#define HEAT_CELL_POWER 8  // float a cell: net power into it, W
#define HEAT_TILES 9       // HeatTile a tile
#define HEAT_TILE_LIST 10  // uint: tiles that take part in this step
#define HEAT_INDIRECT 11   // uvec4: groups of the indirect dispatch, w free
#define HEAT_PARTIAL 12    // float a source tile: sum of weights
#define HEAT_LEDGER 13     // vec4 a particle: joules from sources, their residual, joules lost, their residual

#define HEAT_TILE_STAMPS 14 // int a tile: number of the last step it took part in

#define HEAT_CELL_AREA 15  // float a cell: free surface in m², where evaporation is computed

#define HEAT_SOURCES 4

#define SOURCE_SPHERE 0    // volume, 1 - d²/R²
#define SOURCE_GAUSSIAN 1  // surface that faces it, exp(-r²/(2 sigma²)) around its axis
#define SOURCE_ELLIPSOID 2 // volume, Goldak's double ellipsoid
#define SOURCE_TIP 3       // surface within its radius, coefficient times temperature difference, power at most as stated

// A tile takes part as long as something happened in it or beside it within this many steps.
#define TILE_PATIENCE 8u
// A tile that does nothing but lose heat through its surface takes part every so many steps, for all the time since.
#define TILE_REST 16u

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
    ivec4 step;       // x number of the step, y number of sources, z 1: melted particles leave the lattice, w tiles
    HeatSourceData sources[HEAT_SOURCES];
};

struct HeatTableData {
    vec4 start;       // xyz first enthalpy of the solid, mushy and liquid piece
    vec4 inverseStep; // xyz samples per J/kg
    vec2 samples[HEAT_TABLE_ENTRIES]; // temperature, theta
};

struct HeatTile {
    int lastNeed;   // number of the last step in which something happened
    int lastWarm;   // number of the last step in which its surface was off ambient
    float since;    // simulated time since it last took part, this step included, s
    int reserved;
};

#ifdef __cplusplus
static_assert(sizeof(HeatSourceData) == 96);
static_assert(sizeof(HeatBlock) == 64 + HEAT_SOURCES * 96);
static_assert(sizeof(HeatTableData) == 32 + 8 * HEAT_TABLE_ENTRIES);
static_assert(sizeof(HeatTile) == 16);
} // namespace meltpool
#endif

#endif
