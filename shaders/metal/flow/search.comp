#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the neighbours of moving metal, a little beyond the support, and the still metal that is among them; and the moving
// neighbours of still metal that was listed before.
#define FLOW_CHOOSES
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/near.glsl"

uniform uint substep;

/// Lists still metal that has come to lie beside the liquid, each slot once.
void listBoundary(uint slot) {
    const uint since = counters.restless.z;
    if (atomicExchange(bodies[slot].where.x, since) == since) return;
    const uint entry = atomicAdd(counters.density.w, 1u);
    const uint room = fluid.room.x;
    if (entry >= room) {
        atomicAdd(counters.faults.w, 1u);
        return;
    }
    lists[2 * room + entry] = slot;
    const uint fresh = entry - counters.restless.y;
    if (fresh % GROUP_SIZE == 0) atomicMax(counters.boundary.x, fresh / GROUP_SIZE + 1);
    if ((counters.moving.w + entry) % GROUP_SIZE == 0)
        atomicMax(counters.density.x, (counters.moving.w + entry) / GROUP_SIZE + 1);
}

/// Lists the still metal among the neighbours that is not listed already, which is looked for first.
void listStill(uint base, uint found) {
    for (uint first = 0; first < found; first += 32) {
        uint fresh = 0;
        for (uint k = first; k < min(found, first + 32); ++k) {
            const uint entry = neighbours[base + GROUP_SIZE * k];
            if ((entry & FLOW_RESTS) != 0 && bodies[entry & FLOW_SLOT].where.x != counters.restless.z)
                fresh |= 1u << (k - first);
        }
        for (; fresh != 0; fresh &= fresh - 1)
            listBoundary(neighbours[base + GROUP_SIZE * (first + uint(findLSB(fresh)))] & FLOW_SLOT);
    }
}

bool renews(uint slot) { return bodies[slot].motion.w != 0; }

/// Keeps moving neighbours that do not list anew, in their order; gives their number. They list this particle as long as it
/// lists them: each pair is on both lists or on none, and its forces add up to nothing.
uint keepOthers(uint base, uint found) {
    uint kept = 0;
    for (uint k = 0; k < found; ++k) {
        const uint entry = neighbours[base + GROUP_SIZE * k];
        if ((entry & FLOW_RESTS) == 0 && !renews(entry & FLOW_SLOT)) neighbours[base + GROUP_SIZE * kept++] = entry;
    }
    return kept;
}

/// Slot of an entry: the moving list, then the still metal that was listed beside it.
uint slotOf(uint index) {
    const uint moving = counters.moving.w;
    return lists[index < moving ? index : 2 * fluid.room.x + index - moving];
}

/// Whether an entry is to list its neighbours anew.
bool isWanted(uint index) {
    const uint moving = counters.moving.w;
    if (index >= moving + counters.restless.y) return false;
    const uint slot = slotOf(index);
    return index < moving ? renews(slot) : nearRestless(placeTexel(slot));
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (!choose(isWanted(index), index)) return;
    const bool moves = index < counters.moving.w;
    const uint slot = slotOf(index);
    const uint base = neighbourBase(index);
    const bool all = counters.restless.x > FLOW_RESTLESS_ROOM;
    const uint kept = moves && !all ? keepOthers(base, bodies[slot].where.w) : 0;
    bool fresh;
    const uint found = listNear(slot, placeTexel(slot), base, kept, substep & 1u, moves, fresh);
    if (found == FLOW_NEIGHBOUR_ROOM) atomicAdd(counters.faults.y, 1u);
    if (!moves) {
        bodies[slot].motion.w = found;
        return;
    }
    if (fresh) listStill(base, found);
    bodies[slot].where.w = found;
    velocity[slot].w = 0; // way since the search
}
