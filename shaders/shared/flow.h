// The flow's own buffers and constants, shared by C++ and GLSL; what they mean physically stands in
// core/metal/flow/flow_constants.hpp.
//
// Space is cut into cells at least one kernel support wide, so that a particle's neighbours lie in its own cell and the
// 26 around it. A cell lists its still metal (rebuilt only where the phase changes) and its moving particles (put in
// anew every substep by the pass that moves them). Both lists are in the order of slots, so that every sum has one
// order.
#ifndef MELTPOOL_SHARED_FLOW_H
#define MELTPOOL_SHARED_FLOW_H

#include "glsl_types.h"

#define FLOW_CELL_ROOM 48  // fours; of a cell, for still and for moving particles each; 14 are there at rest density, 27 at most on a lattice
#define FLOW_NEIGHBOUR_ROOM 128 // neighbours kept a particle; 74 are there at rest density

#define FLOW_BODIES 6      // FlowBody a slot
#define FLOW_CELLS 7       // FlowCell a cell
#define FLOW_RESIDENTS 8   // packed places: FLOW_CELL_ROOM moving ones in order, then as many of still metal, a cell; then the slots, likewise
#define FLOW_ENTERED 9     // slots that entered a cell, in no order
#define FLOW_LISTS 10      // moving slots, spare for compacting them, still slots beside moving ones; capacity each; then restless ones
#define FLOW_NEIGHBOURS 11 // slots beside an entry of the lists, entry by entry within a rank
#define FLOW_COUNTERS 12
#define FLOW_DIRTY 13      // cells whose still metal changed, a word a cell; then FLOW_STILL_CHANGES slots that became or ceased to be still
#define FLOW_RESTING 14    // ivec4 a slot of still metal: what other still metal adds to its gradient (xyz) and density (w), in 1/FLOW_REST_UNIT
#define FLOW_CHANGES 15    // the metal's list of slots whose phase changed

#define FLOW_BLOCK 1 // uniform buffer

// Buffer textures of the above
#define FLOW_TEXELS_POSITIONS 0
#define FLOW_TEXELS_BODIES 1 // FLOW_BODY_TEXELS a slot
#define FLOW_TEXELS_NEIGHBOURS 2
#define FLOW_TEXELS_CELLS 3
#define FLOW_TEXELS_RESIDENTS 4
#define FLOW_TEXELS_PLACES 5 // of the residents, four a texel

#define FLOW_BODY_TEXELS 4 // of a FlowBody

#define FLOW_BELONGS_NOWHERE 0u
#define FLOW_BELONGS_STILL 1u
#define FLOW_BELONGS_MOVING 2u

// Bits of a slot in a list of neighbours
#define FLOW_SOLID 0x80000000u // solid metal
#define FLOW_RESTS 0x40000000u // still metal
#define FLOW_SLOT 0x3fffffffu
#define FLOW_RENEWS 0x40000000u // of a moving resident: lists its neighbours anew in this search

#define FLOW_RESTLESS_ROOM 32u // of these; more make all search
#define FLOW_RESTLESS_ALL 0xffffffffu

#define FLOW_STILL_CHANGES 4096u  // slots a frame that may change between still and moving before all still sums are made anew
#define FLOW_CEASED 0x80000000u   // bit of such a slot: it is still no more
#define FLOW_REST_UNIT 16777216.0 // still sums are whole numbers: they take additions and removals in any order without loss
#define FLOW_NO_SUMS 0xffffffffu

#ifdef __cplusplus
namespace meltpool {
#endif

struct FlowBlock {
    vec4 origin;        // xyz low corner of cell (0, 0, 0) in m, w kernel support H in m
    vec4 inverseCell;   // xyz 1/edge of a cell, w 1/H
    vec4 period;        // xyz length after which space repeats, 0 where it does not; w time step in s
    vec4 inversePeriod; // xyz 1/period or 0, w fastest speed allowed in m/s
    vec4 high;          // xyz high corner of the space in m, w half a spacing
    ivec4 cells;        // xyz cells, w capacity in particles
    vec4 body;          // xyz acceleration besides gravity in m/s², w weight of hot still metal against liquid: 0 repels .. 1 wets
    vec4 kernel;        // x s V W(0), y c² in m²/s², z 10 nu in m²/s, w mushy drag over density in 1/s
    vec4 tension;       // x cohesion and y area acceleration (see constants), z slope of surface tension over temperature over density in m³/(s² K), w friction against still metal over that in the liquid
    vec4 search;        // x reach of neighbour lists in m, y way after which they are made anew in m, z scale s of the density sum, w unused
    vec4 arc;           // xyz where the arc's axis meets the metal in m, w 1/(2 sigma²) of its pressure in 1/m²
    vec4 arcAxis;       // xyz unit vector of the arc into the metal, w highest pressure over density in m²/s²
    vec4 wetting;       // x weight of cold still metal, y temperature (K) up to which it is cold, z 1/(temperature from which body.w holds - y), w unused
    uvec4 room;         // x capacity of the lists in particles, y cells, zw unused
    vec4 buoyancy;      // x expansion of the volume in 1/K, y temperature in K at which metal has its whole weight, zw unused
};

struct FlowBody {
    vec4 place;  // xyz position at the start of the substep in m, w density over rest density, scaled
    vec4 normal; // xyz g, the weighted kernel gradient sum in 1/m, w temperature in K
    vec4 motion; // xyz velocity at the start of the substep in m/s, w unused
    uvec4 where; // of moving metal: xy cell entered for the even and the odd substep, z where it belongs, w neighbours;
                 // of still metal: x search of all that it was last listed since, y edition of its still sums, z same, w its cell
};

struct FlowCell {
    uint still; // entries of still metal
    uint even;  // entries of moving particles for even substeps
    uint odd;   // same, odd
    uint dirty; // 1 between the passes that find and tidy changed cells
};

struct FlowCounters {
    uvec4 moving;   // indirect dispatch over the moving list; w its length
    uvec4 search;   // over the moving list and the still metal beside it, without groups where the neighbour lists still hold; w groups of the move pass that are done
    uvec4 boundary; // over still metal that the search has found beside the liquid; w edition of still sums that holds
    uvec4 density;  // over the moving list and the still metal beside it; w number of the latter
    uvec4 faults;   // x cells overfull, y neighbours overfull, z particles no longer finite, w moving list overfull
    uvec4 changes;  // xy length of the list of slots that became or ceased to be still, of even and odd frames; zw unused
    uvec4 restless; // x moving particles whose neighbours went nearly too far (beyond FLOW_RESTLESS_ROOM: all), y still metal listed before this search, z substep of the last search of all, w 1: there must be a search
    uvec4 spare;    // x length of the list being compacted, y changed cells, z unused, w searches made
};

#ifdef __cplusplus
static_assert(sizeof(FlowBlock) == 240);
static_assert(sizeof(FlowBody) == 64);
static_assert(sizeof(FlowCell) == 16);
static_assert(sizeof(FlowCounters) == 128);
} // namespace meltpool
#endif

#endif
