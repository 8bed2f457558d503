// Buffers, cells and distances that every pass of the flow shares.
#include "shared/dispatch.h"
#include "shared/flow.h"
#include "metal/state.glsl"

layout(std140, binding = FLOW_BLOCK) uniform FlowUniform { FlowBlock fluid; };
layout(std430, binding = FLOW_BODIES) buffer Bodies { FlowBody bodies[]; };
layout(std430, binding = FLOW_CELLS) buffer Cells { FlowCell cells[]; };
layout(std430, binding = FLOW_RESIDENTS) buffer Residents { uint residents[]; };
layout(std430, binding = FLOW_ENTERED) buffer Entered { uint entered[]; };
layout(std430, binding = FLOW_LISTS) buffer Lists { uint lists[]; };
layout(std430, binding = FLOW_NEIGHBOURS) buffer Neighbours { uint neighbours[]; };
layout(std430, binding = FLOW_COUNTERS) buffer Counters { FlowCounters counters; };
layout(std430, binding = FLOW_DIRTY) buffer Dirty { uint dirty[]; };
layout(std430, binding = FLOW_RESTING) buffer Resting { ivec4 resting[]; };

// What is gathered from many places is read as texels: some drivers fetch a whole texel at once but storage number by
// number. A pass reads no texels of what it writes.
layout(binding = FLOW_TEXELS_POSITIONS) uniform samplerBuffer positionTexels;
layout(binding = FLOW_TEXELS_BODIES) uniform samplerBuffer bodyTexels;
layout(binding = FLOW_TEXELS_NEIGHBOURS) uniform usamplerBuffer neighbourTexels;
layout(binding = FLOW_TEXELS_CELLS) uniform usamplerBuffer cellTexels;
layout(binding = FLOW_TEXELS_RESIDENTS) uniform usamplerBuffer residentTexels;
layout(binding = FLOW_TEXELS_PLACES) uniform usamplerBuffer residentPlaceTexels;

vec3 placeTexel(uint slot) { return texelFetch(positionTexels, int(slot)).xyz; }

/// Weight of solid metal at this temperature (K) against the liquid.
float wettingAt(float temperature) {
    return mix(fluid.wetting.x, fluid.body.w, clamp((temperature - fluid.wetting.y) * fluid.wetting.z, 0, 1));
}

/// Entry `k` of the neighbour list that begins at `base`.
uint neighbourTexel(uint base, uint k) { return texelFetch(neighbourTexels, int(base + GROUP_SIZE * k)).x; }

/// Counts of a cell: x still metal, y moving metal of this parity.
uvec2 countTexel(uint cell, uint parity) {
    const uvec4 counts = texelFetch(cellTexels, int(cell));
    return uvec2(counts.x, min(parity == 0 ? counts.y : counts.z, FLOW_CELL_ROOM));
}

/// First of the residents of a cell: its moving metal; its still metal.
uint movingBase(uint cell) { return 2 * FLOW_CELL_ROOM * cell; }
uint stillBase(uint cell) { return movingBase(cell) + FLOW_CELL_ROOM; }

/// Where the slot of a resident stands; its packed place stands at `entry` itself.
uint slotEntry(uint entry) { return 2 * FLOW_CELL_ROOM * fluid.room.y + entry; }

void writeResident(uint entry, uint packedPlace, uint slot) {
    residents[entry] = packedPlace;
    residents[slotEntry(entry)] = slot;
}

uint residentTexel(uint entry) { return texelFetch(residentTexels, int(slotEntry(entry))).x; }

/// The cell of a place. Precise, so that every pass comes to the same one.
ivec3 cellAt(vec3 place) {
    precise const vec3 inCells = (place - fluid.origin.xyz) * fluid.inverseCell.xyz;
    return clamp(ivec3(floor(inCells)), ivec3(0), fluid.cells.xyz - 1);
}

/// A place inside its cell in steps of a 1024th of the cell: 0 .. 1023, whole.
vec3 stepsInside(vec3 place) {
    precise const vec3 inCells = (place - fluid.origin.xyz) * fluid.inverseCell.xyz;
    return floor(clamp((inCells - vec3(cellAt(place))) * 1024, vec3(0), vec3(1023)));
}

/// The same as ten bits an axis: one word tells a search whether a particle is near enough to be looked at. Drivers that run
/// on the CPU pay for each word that is read.
uint packPlace(vec3 place) {
    const uvec3 steps = uvec3(stepsInside(place));
    return steps.x | steps.y << 10 | steps.z << 20;
}

uint cellIndex(ivec3 cell) {
    return uint((cell.z * fluid.cells.y + cell.y) * fluid.cells.x + cell.x);
}

/// The cell `steps` away from `cell`, across the seam of repeating axes; false where space ends.
bool neighbourCell(ivec3 cell, ivec3 steps, out uint index) {
    ivec3 other = cell + steps;
#ifdef REPEATS
    const bvec3 repeats = greaterThan(fluid.period.xyz, vec3(0));
    const ivec3 wrapped = other + mix(ivec3(0), fluid.cells.xyz, lessThan(other, ivec3(0))) -
                          mix(ivec3(0), fluid.cells.xyz, greaterThanEqual(other, fluid.cells.xyz));
    other = mix(other, wrapped, repeats); // no remainders: integer division is slow, on a CPU above all
#endif
    index = cellIndex(other);
    return all(greaterThanEqual(other, ivec3(0))) && all(lessThan(other, fluid.cells.xyz));
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
vec3 apart(vec3 a, vec3 b) {
    const vec3 straight = a - b;
#ifdef REPEATS
    return straight - fluid.period.xyz * round(straight * fluid.inversePeriod.xyz);
#else
    return straight;
#endif
}

/// True where a neighbour list that is made around `place` must be made anew: a restless particle is within its reach.
bool nearRestless(vec3 place) {
    const uint restless = counters.restless.x;
    if (restless > FLOW_RESTLESS_ROOM) return true;
    const float reach = fluid.search.x * fluid.search.x;
    bool near = false;
    for (uint k = 0; k < restless; ++k) {
        const vec3 d = apart(place, placeTexel(lists[3 * fluid.room.x + k]));
        near = near || dot(d, d) < reach;
    }
    return near;
}

#ifdef FLOW_CHOOSES
shared uint chosen[GROUP_SIZE];
shared uint chosenCount;

/// Hands the entries that a group is to work on to its first invocations, in no order: those beyond have nothing to do and
/// cost nothing. Every invocation of the group must call it. False where there is none for this one.
bool choose(bool wanted, inout uint entry) {
    if (gl_LocalInvocationIndex == 0) chosenCount = 0;
    barrier();
    if (wanted) chosen[atomicAdd(chosenCount, 1u)] = entry;
    barrier();
    if (gl_LocalInvocationIndex >= chosenCount) return false;
    entry = chosen[gl_LocalInvocationIndex];
    return true;
}
#endif

/// Puts a moving slot into the cell that the next substep, of this parity (0 even, 1 odd), finds it in.
void enterCell(uint slot, vec3 place, uint parity) {
    const uint cell = cellIndex(cellAt(place));
    const uint entry = parity == 0 ? atomicAdd(cells[cell].even, 1u) : atomicAdd(cells[cell].odd, 1u);
    if (entry < FLOW_CELL_ROOM)
        entered[cell * FLOW_CELL_ROOM + entry] = slot;
    else
        atomicAdd(counters.faults.x, 1u);
    bodies[slot].where[parity] = cell;
}

uint cellMoving(uint cell, uint parity) {
    return min(parity == 0 ? cells[cell].even : cells[cell].odd, FLOW_CELL_ROOM);
}

/// Place of the first neighbour of entry `index` of the lists; the next ones follow GROUP_SIZE apart.
uint neighbourBase(uint index) {
    return index / GROUP_SIZE * (GROUP_SIZE * FLOW_NEIGHBOUR_ROOM) + index % GROUP_SIZE;
}
