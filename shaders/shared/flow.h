// Buffers and constants of the flow, shared by C++ and GLSL. core/metal/flow/flow_constants.hpp derives the constants
// from a liquid's properties.
//
// Moving metal is liquid, or part of a loose solid fragment, or froze in flight and belongs to no fragment yet: the
// last flies on with the liquid until it touches fixed metal. Wall metal is all other solid metal: it is fixed and
// bounds the liquid.
//
// Space is cut into cells at least one kernel support wide, so that a particle's neighbours are in its own cell and the
// 26 around it. Each cell lists its wall particles, which change only where the phase changes, and its moving
// particles, which the move pass puts into cells again in every substep. Both lists are ordered by slot, so that sums
// over neighbours have one order and repeated runs give equal bits. Only cells that hold metal have memory for lists.
//
// Boundary particles are solid ones, of walls or fragments, within the reach of liquid. Only liquid and boundary
// particles have neighbour lists.
#ifndef MELTPOOL_SHARED_FLOW_H
#define MELTPOOL_SHARED_FLOW_H

#include "glsl_types.h"

#define FLOW_CELL_CAPACITY 48       // wall particles of a cell, and moving ones; a multiple of 4; 14 at rest density, at most 27 on a lattice
#define FLOW_NEIGHBOUR_CAPACITY 128 // neighbours listed for a particle; 74 at rest density

// Storage buffers
#define FLOW_PARTICLES 6     // FlowParticle for each slot
#define FLOW_CELLS 7         // FlowCell for each cell
// Lists of cells, FLOW_PAGE_WORDS each: pages of wall metal, which stay with their cells, then pages of moving metal,
// handed out in every substep; page 0 of both is unused.
#define FLOW_PAGES 8
#define FLOW_NEXT_IN_CELL 9 // next slot of each slot's cell: of moving particles, and of new wall particles, unordered
#define FLOW_LISTS 10        // moving slots, see flow/common.glsl
#define FLOW_NEIGHBOURS 11   // neighbour lists, see flow/common.glsl
#define FLOW_COUNTERS 12     // FlowCounters
#define FLOW_CHANGED 13      // cells with changed wall particles; then FLOW_WALL_CHANGES slots with changed wall state
// ivec4 for each wall slot: the share of other wall metal in its gradient (xyz) and density (w), in
// 1/FLOW_WALL_SUM_UNIT.
#define FLOW_WALL_SUMS 14
#define FLOW_PHASE_CHANGES 15 // the metal's list of slots whose phase changed

#define FLOW_BLOCK 1 // uniform buffer

// Buffer textures over the same buffers
#define FLOW_TEXELS_POSITIONS 0
#define FLOW_TEXELS_PARTICLES 1 // FLOW_PARTICLE_TEXELS for each slot
#define FLOW_TEXELS_NEIGHBOURS 2
#define FLOW_TEXELS_CELLS 3
#define FLOW_TEXELS_PAGE_SLOTS 4
#define FLOW_TEXELS_PAGE_POSITIONS 5 // four packed positions in a texel

#define FLOW_PARTICLE_TEXELS 4                   // texels of a FlowParticle
#define FLOW_CELL_TEXELS 2                       // texels of a FlowCell
#define FLOW_PAGE_WORDS (2 * FLOW_CELL_CAPACITY) // packed positions, then slots

// FlowParticle.group
#define FLOW_GROUP_NONE 0u
#define FLOW_GROUP_WALL 1u
#define FLOW_GROUP_MOVING 2u

// Bits of a slot in a list of neighbours or in the list of a cell
#define FLOW_SOLID 0x80000000u // solid metal, wall or fragment
#define FLOW_WALL 0x40000000u  // wall metal (in lists of neighbours)
#define FLOW_RENEWS 0x40000000u // its own list is rebuilt in this search (in lists of cells)
#define FLOW_SLOT 0x3fffffffu

#define FLOW_STALE_CAPACITY 32u    // particles with stale neighbour lists that a search renews one by one; with more it renews all lists
#define FLOW_STALE_ALL 0xffffffffu // all lists are stale

#define FLOW_WALL_CHANGES 4096u          // slots a frame with changed wall state before all wall sums are rebuilt
#define FLOW_NO_LONGER_WALL 0x80000000u  // bit of such a slot: it ceased to be wall
#define FLOW_WALL_SUM_UNIT 16777216.0    // unit of wall sums: integers lose nothing in any order of changes
#define FLOW_NO_WALL_SUMS 0xffffffffu    // FlowParticle.wallSumGeneration of a slot without valid sums

#define FLOW_TENSION_SLOPES 16 // a multiple of 4

#ifdef __cplusplus
namespace meltpool {
#endif

struct FlowBlock {
    vec3 origin;          // low corner of cell (0, 0, 0), m
    float support;        // H of the kernel, m
    vec3 inverseCellSize; // 1/m
    float inverseSupport; // 1/m
    vec3 period;          // length after which space repeats, 0 where it does not, m
    float timeStep;       // s
    vec3 inversePeriod;   // 1/period, 0 where space does not repeat, 1/m
    float speedLimit;     // fastest speed allowed, m/s
    vec3 high;            // high corner of space, m
    float halfSpacing;    // half a particle spacing, m
    ivec3 cells;
    int capacity;       // slots of the metal
    vec3 acceleration;  // besides gravity, m/s²
    float hotWetting;   // attraction by hot wall metal over that by liquid: 0 repels .. 1 wets
    float kernelSelf;   // s V W(0)
    float soundSpeedSquared; // m²/s²
    float pairFriction; // 10 nu, m²/s
    float mushyDrag;    // mushy drag over density, 1/s
    float cohesion;     // m/s²
    float areaForce;    // prefactor of the surface area force, m²/s²
    float firstSlopeAt; // temperature of the first of tensionSlopes, K
    float wallFriction; // friction against solid metal over that in the liquid
    float reach;        // reach of neighbour lists, m
    float freeWay;      // relative way of neighbours after which lists are stale, m
    float densityScale; // s of the density sum
    float coldWetting;  // attraction by cold wall metal over that by liquid
    vec3 arcCentre;     // point where the arc's axis meets the metal, m
    float arcInverseVariance; // 1/(2 sigma²) of the arc's pressure, 1/m²
    vec3 arcAxis;       // unit vector of the arc into the metal
    float arcPeak;      // peak pressure of the arc over density, m²/s²
    float arcShear;     // peak drag of its jet along the surface over density, m²/s²
    float inverseArcSigma; // 1/sigma of its pressure, 1/m
    float coldBelow;    // wall metal is cold up to this temperature, K
    float inverseWettingRange; // 1/(temperature from which wall metal is hot - coldBelow), 1/K
    float expansion;           // expansion of the volume over temperature, 1/K
    float referenceTemperature; // temperature at which metal has its whole weight, K
    uint rowCapacity;           // capacity of neighbour lists, a multiple of GROUP_SIZE
    uint wallPageCapacity; // pages of wall metal, with the unused one
    uint movingPageCapacity; // pages of moving metal, with the unused one
    uint cellCount;
    float inverseSlopeStep; // 1/(K from one of tensionSlopes to the next), 1/K
    uint unused0;
    vec4 tensionSlopes[FLOW_TENSION_SLOPES / 4]; // slopes of surface tension over temperature, over density, m³/(s² K)
};

struct FlowParticle {
    vec3 position;     // position at the start of the substep, m
    float density;     // density over rest density, scaled
    vec3 normal;       // weighted sum of kernel gradients, points into the metal, 1/m
    float temperature; // K
    vec3 velocity;     // velocity at the start of the substep, m/s
    float tether;      // of liquid: PHASE_TETHER_BITS at the start of the substep
    uint cell;         // the cell that lists it
    uint group;        // FLOW_GROUP_...
    uint listedSince;  // of solid metal: FlowCounters.fullSearch when it last became a boundary particle
    uint wallSumGeneration; // of wall metal: FlowCounters.wallSumGeneration of its wall sums; of moving
                            // metal: 1 if the search in progress rebuilds its neighbour list
};

struct FlowCell {
    uint walls;  // number of wall particles
    uint moving; // number of moving particles
    uint wallPage;     // page of wall particles; 0: none yet
    uint movingPage;   // page of moving particles, if there are any
    uint firstMoving;  // slot of the last moving particle put into the cell; the others follow in FLOW_NEXT_IN_CELL
    uint firstNewWall; // slot + 1 of the last new wall particle between these two passes, 0 for none; the others follow
    uint hasWallPage;  // 1: a page was requested
    uint changed;      // 1 between the passes that find and compact changed cells
};

struct FlowCounters {
    uvec3 movingGroups; // indirect dispatch over moving metal
    uint liquids;       // liquid moving particles; from classify.comp to compact.comp also metal that began to move
    uvec3 searchGroups; // groups over moving metal and boundary particles; none while the neighbour lists hold
    uint moveGroupsDone;
    uvec3 boundaryGroups;   // groups over the boundary particles that this search found
    uint wallSumGeneration; // generation of the valid wall sums
    uvec3 densityGroups;    // groups over moving metal and boundary particles
    uint boundary;          // boundary particles
    uint cellsOverfull;     // faults so far
    uint neighboursOverfull;
    uint notFinite;
    uint listsOverfull;
    uint wallChanges[2]; // slots that became or ceased to be wall, in even and odd frames
    uint frame;
    uint searches;       // searches made so far
    uint stale;          // moving particles whose neighbours moved nearly too far; beyond FLOW_STALE_CAPACITY all
    uint boundaryBefore; // boundary particles before this search
    uint fullSearch; // number of the last search that renewed all lists
    uint searchDue;  // 1: a neighbour moved too far, so that the next substep must search
    uint fragments;  // moving particles that are part of fragments
    uint compactedLiquids; // liquid slots of the moving list under compaction
    uint compactedFragments;
    uint changedCells;
    uint wallPages;   // wall pages handed out so far
    uint movingPages; // moving pages handed out for the next search
    uint reserved0, reserved1;
    uvec3 listGroups; // indirect dispatch over the rows whose lists a search rebuilds
    uint listed;      // number of these rows, which are stored in the place of the slots under compaction
};

#ifdef __cplusplus
static_assert(sizeof(FlowBlock) == 304);
static_assert(sizeof(FlowParticle) == 64);
static_assert(sizeof(FlowCell) == 32);
static_assert(sizeof(FlowCounters) == 160);
} // namespace meltpool
#endif

#endif
