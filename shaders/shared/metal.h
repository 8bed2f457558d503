// The physical metal's state on the GPU, shared by heat and flow: particle buffers, phase bits, lattice, bindings.
//
// A particle has one slot for life: lists of slots are sorted and compacted, particles are not. The buffers, one entry
// a slot:
//   position  vec4   xyz metres, w temperature in K           (xyz: flow; w: heat)
//   velocity  vec4   xyz m/s, w free for the flow             (flow)
//   heat      vec4   x specific enthalpy J/kg, y its residual (the part of x that float cannot hold, to be added),
//                    z highest temperature so far in K, w seconds spent between 800 and 500 degrees C while cooling
//                    (heat)
//   frozenAt  float  time at which it last froze, s since the start; METAL_MOLTEN: it is molten; 0: it never was. For
//                    pictures alone: no pass of the metal reads it (heat)
//   phase     uint   bits below (LIQUID, LATTICE, FRESH: heat; TETHER: flow; rest: its maker)
//
// Solid metal that never moved sits on a lattice of cubes with the particle spacing as edge; `lattice` holds slot + 1
// for each cell, 0 where no particle sits. Cells are stored tile by tile, 4 x 4 x 4 cells a tile.
//
// `changes`, uint 0 their number, then slots: those whose phase bits heat or the labelling of fragments changed, in no
// order, some perhaps twice. Each change appends a slot; the reader (flow) empties the list; a number beyond the
// capacity means that some were dropped: look at every slot. The list omits new slots (MetalCounters.particles) and the
// changes that MetalState::regroupings() counts.
#ifndef MELTPOOL_SHARED_METAL_H
#define MELTPOOL_SHARED_METAL_H

#include "glsl_types.h"

#define PHASE_ALIVE 1u    // the slot is in use
#define PHASE_LIQUID 2u   // moves with the flow; set above and cleared below the two fractions meltsAbove and freezesBelow of MetalBlock
#define PHASE_LATTICE 4u  // sits at the centre of its lattice cell: conducts with its neighbours there
#define PHASE_HELD 8u     // its temperature is fixed: a wall; off the lattice, one that no heat crosses
#define PHASE_CLAMPED 16u // held by a fixture: never falls
#define PHASE_FRESH 32u   // froze since solid fragments were last labelled: bonds with any metal that it touches
#define PHASE_FRAGMENT_SHIFT 8 // from this bit on: number of its free solid fragment, 0 for metal held by clamps
#define PHASE_FRAGMENT_BITS (255u << PHASE_FRAGMENT_SHIFT)
#define PHASE_TETHER_SHIFT 16 // from this bit on: tether of the flow's metal to fixed metal, see PHASE_TETHER_MOST
#define PHASE_TETHER_MOST 31u // beside fixed metal; one less from neighbour to neighbour. 0: it flies
#define PHASE_TETHER_BITS (PHASE_TETHER_MOST << PHASE_TETHER_SHIFT)

#define METAL_MOLTEN -1.0f // time of freezing of molten metal

#define TILE_EDGE 4
#define TILE_CELLS 64

// Storage buffers with one binding in every pass of the metal; 6 to 15 belong to the pass.
#define METAL_POSITION 0
#define METAL_VELOCITY 1
#define METAL_HEAT 2
#define METAL_PHASE 3
#define METAL_LATTICE 4
#define METAL_COUNTERS 5

#define METAL_BLOCK 0 // uniform buffer

#ifdef __cplusplus
namespace meltpool {
#endif

struct MetalBlock {
    vec3 origin;           // low corner of lattice cell (0, 0, 0), m
    float spacing;         // edge of a cell, m
    ivec3 tiles;           // size of the lattice in tiles
    int capacity;          // capacity in particles
    vec3 gravity;          // m/s²
    float particleMass;    // kg
    float solidusEnthalpy; // J/kg
    float liquidusEnthalpy;
    float meltsAbove;   // fraction of liquid above which a solid particle becomes liquid
    float freezesBelow; // fraction of liquid below which a liquid particle becomes solid
};

struct MetalCounters {
    uint particles; // slots handed out so far
    uint melted;    // slots that turned liquid in the last heat step
    uint frozen;    // slots that turned solid in it
    uint reserved;
};

#ifdef __cplusplus
static_assert(sizeof(MetalBlock) == 64);
static_assert(sizeof(MetalCounters) == 16);
} // namespace meltpool
#endif

#endif
