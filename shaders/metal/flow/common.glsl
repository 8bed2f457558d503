// Buffers, cells and distances that every pass of the flow shares.
#include "shared/dispatch.h"
#include "shared/flow.h"
#include "metal/state.glsl"

layout(std140, binding = FLOW_BLOCK) uniform FlowUniform { FlowBlock fluid; };
layout(std430, binding = FLOW_PARTICLES) buffer Particles { FlowParticle particles[]; };
layout(std430, binding = FLOW_CELLS) buffer Cells { FlowCell cells[]; };
layout(std430, binding = FLOW_CELL_LISTS) buffer CellLists { uint cellLists[]; };
layout(std430, binding = FLOW_BINNED) buffer Binned { uint binned[]; };
layout(std430, binding = FLOW_LISTS) buffer Lists { uint lists[]; };
layout(std430, binding = FLOW_NEIGHBOURS) buffer Neighbours { uint neighbours[]; };
layout(std430, binding = FLOW_COUNTERS) buffer Counters { FlowCounters counters; };
layout(std430, binding = FLOW_CHANGED) buffer Changed { uint changed[]; };
layout(std430, binding = FLOW_WALL_SUMS) buffer WallSums { ivec4 wallSums[]; };

// What is gathered from many places is read as texels: some drivers fetch a whole texel at once but storage word by word.
// A pass reads no texels of what it writes.
layout(binding = FLOW_TEXELS_POSITIONS) uniform samplerBuffer positionTexels;
layout(binding = FLOW_TEXELS_PARTICLES) uniform samplerBuffer particleTexels;
layout(binding = FLOW_TEXELS_NEIGHBOURS) uniform usamplerBuffer neighbourTexels;
layout(binding = FLOW_TEXELS_CELLS) uniform usamplerBuffer cellTexels;
layout(binding = FLOW_TEXELS_CELL_SLOTS) uniform usamplerBuffer cellSlotTexels;
layout(binding = FLOW_TEXELS_CELL_POSITIONS) uniform usamplerBuffer cellPositionTexels;

// `lists` holds, one behind the other: the moving slots; the same while they are compacted; the wall slots beside moving
// metal (listCapacity each); the number of neighbours of each entry of the moving list and then of the wall list
// (2 listCapacity); the slots with stale neighbour lists.
uint compactedIndex(uint k) { return fluid.listCapacity + k; }
uint wallIndex(uint k) { return 2 * fluid.listCapacity + k; }
uint neighbourCountIndex(uint entry) { return 3 * fluid.listCapacity + entry; }
uint staleIndex(uint k) { return 5 * fluid.listCapacity + k; }

/// Slot of an entry: the moving list comes first, then the wall list.
uint slotOf(uint entry) {
    const uint moving = counters.moving;
    return lists[entry < moving ? entry : wallIndex(entry - moving)];
}

/// Place of the first neighbour of an entry in `neighbours`; the next ones follow GROUP_SIZE apart.
uint neighbourBase(uint entry) {
    return entry / GROUP_SIZE * (GROUP_SIZE * FLOW_NEIGHBOUR_CAPACITY) + entry % GROUP_SIZE;
}

/// Neighbour `k` of the list that begins at `base`.
uint neighbourTexel(uint base, uint k) { return texelFetch(neighbourTexels, int(base + GROUP_SIZE * k)).x; }

vec3 positionTexel(uint slot) { return texelFetch(positionTexels, int(slot)).xyz; }

/// Attraction of liquid by solid metal of this temperature (K), over that by liquid. Own derivation: the contact line stops
/// on metal on which the liquid would freeze (Schiaffino and Sonin 1997); flow_constants.cpp holds the measured angles.
float wettingAt(float temperature) {
    return mix(fluid.coldWetting, fluid.hotWetting, clamp((temperature - fluid.coldBelow) * fluid.inverseWettingRange, 0, 1));
}

/// Number of particles of a cell: x wall, y moving.
uvec2 cellCounts(uint cell) {
    const uvec2 counts = texelFetch(cellTexels, int(cell)).xy;
    return uvec2(counts.x, min(counts.y, FLOW_CELL_CAPACITY));
}

/// Index of the first moving particle, and of the first wall particle, of a cell in the lists of cells.
uint cellMovingBase(uint cell) { return 2 * FLOW_CELL_CAPACITY * cell; }
uint cellWallBase(uint cell) { return cellMovingBase(cell) + FLOW_CELL_CAPACITY; }

/// Where the slot that belongs to a packed position stands.
uint cellSlotIndex(uint index) { return 2 * FLOW_CELL_CAPACITY * fluid.cellCount + index; }

void writeCellEntry(uint index, uint packedPosition, uint slot) {
    cellLists[index] = packedPosition;
    cellLists[cellSlotIndex(index)] = slot;
}

uint cellSlotTexel(uint index) { return texelFetch(cellSlotTexels, int(cellSlotIndex(index))).x; }

/// The cell of a position. Precise, so that every pass comes to the same one.
ivec3 cellAt(vec3 position) {
    precise const vec3 inCells = (position - fluid.origin) * fluid.inverseCellSize;
    return clamp(ivec3(floor(inCells)), ivec3(0), fluid.cells - 1);
}

/// A position inside its cell in whole steps of a 1024th of the cell: 0 .. 1023.
vec3 stepsInside(vec3 position) {
    precise const vec3 inCells = (position - fluid.origin) * fluid.inverseCellSize;
    return floor(clamp((inCells - vec3(cellAt(position))) * 1024, vec3(0), vec3(1023)));
}

/// The same with ten bits an axis: a search reads one word to see whether a particle is near. Drivers that run on the CPU
/// pay for each word read.
uint packPosition(vec3 position) {
    const uvec3 steps = uvec3(stepsInside(position));
    return steps.x | steps.y << 10 | steps.z << 20;
}

uint cellIndex(ivec3 cell) {
    return uint((cell.z * fluid.cells.y + cell.y) * fluid.cells.x + cell.x);
}

/// The cell `steps` away from `cell`, across the seam of repeating axes; false where space ends.
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

/// Goes on to the next of the 27 steps from (-1, -1, -1) to (1, 1, 1).
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

/// Lists a moving slot in the cell that the next search finds it in.
void binParticle(uint slot, vec3 position) {
    const uint cell = cellIndex(cellAt(position));
    const uint entry = atomicAdd(cells[cell].moving, 1u);
    if (entry < FLOW_CELL_CAPACITY)
        binned[cell * FLOW_CELL_CAPACITY + entry] = slot;
    else
        atomicAdd(counters.cellsOverfull, 1u);
    particles[slot].cell = cell;
}
