// Buffers, cells and distances that every pass of the flow shares.
#include "shared/dispatch.h"
#include "shared/flow.h"
#include "metal/state.glsl"

layout(std140, binding = FLOW_BLOCK) uniform FlowUniform { FlowBlock fluid; };
layout(std430, binding = FLOW_PARTICLES) buffer Particles { FlowParticle particles[]; };
layout(std430, binding = FLOW_CELLS) buffer Cells { FlowCell cells[]; };
layout(std430, binding = FLOW_PAGES) buffer Pages { uint pages[]; };
layout(std430, binding = FLOW_NEXT_IN_CELL) buffer NextInCell { uint nextInCell[]; };
layout(std430, binding = FLOW_LISTS) buffer Lists { uint lists[]; };
layout(std430, binding = FLOW_NEIGHBOURS) buffer Neighbours { uint neighbours[]; };
layout(std430, binding = FLOW_COUNTERS) buffer Counters { FlowCounters counters; };
layout(std430, binding = FLOW_CHANGED) buffer Changed { uint changed[]; };
layout(std430, binding = FLOW_WALL_SUMS) buffer WallSums { ivec4 wallSums[]; };

// SYNCHRONOUS_DRIVER: passes that gather from many places read texels, which it fetches whole, but storage word by
// word. A pass reads no texels of the buffers that it writes.
layout(binding = FLOW_TEXELS_POSITIONS) uniform samplerBuffer positionTexels;
layout(binding = FLOW_TEXELS_PARTICLES) uniform samplerBuffer particleTexels;
layout(binding = FLOW_TEXELS_NEIGHBOURS) uniform usamplerBuffer neighbourTexels;
layout(binding = FLOW_TEXELS_CELLS) uniform usamplerBuffer cellTexels;
layout(binding = FLOW_TEXELS_PAGE_SLOTS) uniform usamplerBuffer pageSlotTexels;
layout(binding = FLOW_TEXELS_PAGE_POSITIONS) uniform usamplerBuffer pagePositionTexels;

// `lists` has three parts: the moving slots, liquid ones from the front on and those of fragments from the end back
// (capacity in all); these slots during compaction (likewise), and in a search the rows whose neighbour lists it
// rebuilds; the slots with stale neighbour lists.
uint liquidIndex(uint k) { return k; }
uint fragmentIndex(uint k) { return uint(fluid.capacity) - 1 - k; }
uint compactedIndex(uint index) { return uint(fluid.capacity) + index; }
uint staleIndex(uint k) { return 2 * uint(fluid.capacity) + k; }

/// Slot of moving metal; the liquid comes first.
uint movingSlot(uint k) {
    const uint liquids = counters.liquids;
    return lists[k < liquids ? liquidIndex(k) : fragmentIndex(k - liquids)];
}

// `neighbours` holds the neighbour lists, row by row (liquid particles come first, then boundary particles): entries k
// of the lists of a work group are side by side; then the slots of boundary particles; then the length of each row.
uint boundaryIndex(uint k) { return FLOW_NEIGHBOUR_CAPACITY * fluid.rowCapacity + k; }
uint neighbourCountIndex(uint row) { return (FLOW_NEIGHBOUR_CAPACITY + 1) * fluid.rowCapacity + row; }

/// Rows in use.
uint rowCount() { return min(counters.liquids + counters.boundary, fluid.rowCapacity); }

/// Slot of a row.
uint slotOf(uint row) {
    const uint liquids = counters.liquids;
    return row < liquids ? lists[liquidIndex(row)] : neighbours[boundaryIndex(row - liquids)];
}

/// Length of a row; 0 if it exceeds the capacity.
uint neighbourCount(uint row) { return row < fluid.rowCapacity ? neighbours[neighbourCountIndex(row)] : 0u; }

/// Index of the first neighbour of a row in `neighbours`; the next ones follow GROUP_SIZE apart.
uint neighbourBase(uint row) {
    return row / GROUP_SIZE * (GROUP_SIZE * FLOW_NEIGHBOUR_CAPACITY) + row % GROUP_SIZE;
}

/// Neighbour `k` of the list that begins at `base`.
uint neighbourTexel(uint base, uint k) { return texelFetch(neighbourTexels, int(base + GROUP_SIZE * k)).x; }

/// True for metal that the flow moves: liquid, and metal that froze in flight until it touches fixed metal or has
/// become a fragment of its own.
bool flows(uint bits) {
    return (bits & PHASE_LIQUID) != 0 ||
           ((bits & PHASE_FRESH) != 0 && (bits & (PHASE_TETHER_BITS | PHASE_FRAGMENT_BITS | PHASE_LATTICE)) == 0);
}

vec3 positionTexel(uint slot) { return texelFetch(positionTexels, int(slot)).xyz; }

/// Attraction of liquid by solid metal of this temperature (K), over that by liquid. Own derivation: the contact line stops
/// on metal on which the liquid would freeze (Schiaffino and Sonin 1997); flow_constants.cpp holds the measured angles.
float wettingAt(float temperature) {
    return mix(fluid.coldWetting, fluid.hotWetting, clamp((temperature - fluid.coldBelow) * fluid.inverseWettingRange, 0, 1));
}

/// Number of listed particles of a cell: x wall, y moving; their pages: z wall, w moving.
uvec4 readCell(uint cell) {
    const uvec4 read = texelFetch(cellTexels, FLOW_CELL_TEXELS * int(cell));
    return uvec4(read.z == 0 ? 0u : read.x, read.w == 0 ? 0u : min(read.y, FLOW_CELL_CAPACITY), read.zw);
}

/// Index in `pages` of the first particle of a page.
uint wallBase(uint page) { return FLOW_PAGE_WORDS * page; }
uint movingBase(uint page) { return FLOW_PAGE_WORDS * (fluid.wallPageCapacity + page); }

/// Index of the slot that belongs to a packed position.
uint pageSlotIndex(uint index) { return index + FLOW_CELL_CAPACITY; }

void writePageEntry(uint index, uint packedPosition, uint slot) {
    pages[index] = packedPosition;
    pages[pageSlotIndex(index)] = slot;
}

uint pageSlotTexel(uint index) { return texelFetch(pageSlotTexels, int(pageSlotIndex(index))).x; }

/// Page number `page`, 0 if it exceeds the capacity.
uint checkedPage(uint page, uint capacity) {
    if (page < capacity) return page;
    atomicAdd(counters.cellsOverfull, 1u);
    return 0;
}

/// Gives a cell its page of wall metal for the following passes.
void needWallPage(uint cell) {
    if (cells[cell].hasWallPage != 0 || atomicExchange(cells[cell].hasWallPage, 1u) != 0) return;
    cells[cell].wallPage = checkedPage(atomicAdd(counters.wallPages, 1u) + 1, fluid.wallPageCapacity);
}

/// The cell of a position. Precise, so that all passes agree.
ivec3 cellAt(vec3 position) {
    precise const vec3 inCells = (position - fluid.origin) * fluid.inverseCellSize;
    return clamp(ivec3(floor(inCells)), ivec3(0), fluid.cells - 1);
}

/// A position inside its cell in whole steps of a 1024th of the cell: 0 .. 1023.
vec3 stepsInside(vec3 position) {
    precise const vec3 inCells = (position - fluid.origin) * fluid.inverseCellSize;
    return floor(clamp((inCells - vec3(cellAt(position))) * 1024, vec3(0), vec3(1023)));
}

/// The steps inside the cell with ten bits an axis: a search reads one word to see whether a particle is near.
/// SYNCHRONOUS_DRIVER: each word costs time.
uint packPosition(vec3 position) {
    const uvec3 steps = uvec3(stepsInside(position));
    return steps.x | steps.y << 10 | steps.z << 20;
}

uint cellIndex(ivec3 cell) {
    return uint((cell.z * fluid.cells.y + cell.y) * fluid.cells.x + cell.x);
}

/// The cell `steps` away from `cell`, across the seam of repeating axes; returns false where space ends.
bool neighbourCell(ivec3 cell, ivec3 steps, out uint index) {
    ivec3 other = cell + steps;
#ifdef REPEATS
    const bvec3 repeats = greaterThan(fluid.period, vec3(0));
    const ivec3 wrapped = other + mix(ivec3(0), fluid.cells, lessThan(other, ivec3(0))) -
                          mix(ivec3(0), fluid.cells, greaterThanEqual(other, fluid.cells));
    other = mix(other, wrapped, repeats); // no remainders: integer division is slow, on a CPU above all
#endif
    index = cellIndex(other);
    return all(greaterThanEqual(other, ivec3(0))) && all(lessThan(other, fluid.cells));
}

/// Advances to the next of the 27 steps from (-1, -1, -1) to (1, 1, 1).
void nextStep(inout ivec3 step) {
    ++step.x;
    if (step.x > 1) {
        step.x = -1;
        ++step.y;
    }
    if (step.y > 1) {
        step.y = -1;
        ++step.z;
    }
}

/// a - b, by the shorter way round where space repeats.
vec3 displacement(vec3 a, vec3 b) {
    const vec3 straight = a - b;
#ifdef REPEATS
    return straight - fluid.period * round(straight * fluid.inversePeriod);
#else
    return straight;
#endif
}

/// True where a neighbour list made around `position` must be renewed: a particle with a stale list is within its reach.
bool nearStale(vec3 position) {
    const uint stale = counters.stale;
    if (stale > FLOW_STALE_CAPACITY) return true;
    const float reach = fluid.reach * fluid.reach;
    bool near = false;
    for (uint k = 0; k < stale; ++k) {
        const vec3 d = displacement(position, positionTexel(lists[staleIndex(k)]));
        near = near || dot(d, d) < reach;
    }
    return near;
}

/// Puts a moving slot into the cell that the next search finds it in.
void binParticle(uint slot, vec3 position) {
    const uint cell = cellIndex(cellAt(position));
    const uint before = atomicAdd(cells[cell].moving, 1u);
    if (before == 0)
        cells[cell].movingPage = checkedPage(atomicAdd(counters.movingPages, 1u) + 1, fluid.movingPageCapacity);
    if (before >= FLOW_CELL_CAPACITY) atomicAdd(counters.cellsOverfull, 1u);
    nextInCell[slot] = atomicExchange(cells[cell].firstMoving, slot);
    particles[slot].cell = cell;
}
