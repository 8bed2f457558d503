#version 450 core
#extension GL_GOOGLE_include_directive : require
// Lists the neighbours of moving metal, a little beyond the support, and the wall metal among them; and the moving
// neighbours of wall metal that was listed before.
#include "metal/flow/common.glsl"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/flow/choose.glsl"
#include "metal/flow/neighbours.glsl"

/// Lists wall metal that has come to lie beside moving metal, each slot once.
void listWall(uint slot) {
    const uint since = counters.fullSearch;
    if (atomicExchange(particles[slot].listedSince, since) == since) return;
    const uint wall = atomicAdd(counters.walls, 1u);
    if (wall >= fluid.listCapacity) {
        atomicAdd(counters.listsOverfull, 1u);
        return;
    }
    lists[wallIndex(wall)] = slot;
    const uint added = wall - counters.wallsBefore;
    if (added % GROUP_SIZE == 0) atomicMax(counters.boundaryGroups.x, added / GROUP_SIZE + 1);
    const uint entry = counters.moving + wall;
    if (entry % GROUP_SIZE == 0) atomicMax(counters.densityGroups.x, entry / GROUP_SIZE + 1);
}

/// Lists the wall metal among the neighbours that is not listed yet. First looks for it, so that most particles do no more.
void listWalls(uint base, uint found) {
    for (uint first = 0; first < found; first += 32) {
        uint unlisted = 0;
        for (uint k = first; k < min(found, first + 32); ++k) {
            const uint neighbour = neighbours[base + GROUP_SIZE * k];
            if ((neighbour & FLOW_WALL) != 0 && particles[neighbour & FLOW_SLOT].listedSince != counters.fullSearch)
                unlisted |= 1u << (k - first);
        }
        for (; unlisted != 0; unlisted &= unlisted - 1)
            listWall(neighbours[base + GROUP_SIZE * (first + uint(findLSB(unlisted)))] & FLOW_SLOT);
    }
}

bool renews(uint slot) { return particles[slot].renews != 0; }

/// Keeps the moving neighbours that do not renew their lists, in their order; gives their number. They list this particle as
/// long as it lists them: each pair is on both lists or on none, so that its two forces cancel.
uint keepOthers(uint base, uint found) {
    uint kept = 0;
    for (uint k = 0; k < found; ++k) {
        const uint neighbour = neighbours[base + GROUP_SIZE * k];
        if ((neighbour & FLOW_WALL) == 0 && !renews(neighbour & FLOW_SLOT))
            neighbours[base + GROUP_SIZE * kept++] = neighbour;
    }
    return kept;
}

/// Whether an entry must list its neighbours anew.
bool isWanted(uint entry) {
    const uint moving = counters.moving;
    if (entry >= moving + counters.wallsBefore) return false;
    const uint slot = slotOf(entry);
    return entry < moving ? renews(slot) : nearStale(positionTexel(slot));
}

void main() {
    uint entry = gl_GlobalInvocationID.x;
    if (!choose(isWanted(entry), entry)) return;
    const bool moves = entry < counters.moving;
    const uint slot = slotOf(entry);
    const uint base = neighbourBase(entry);
    const bool all = counters.stale > FLOW_STALE_CAPACITY;
    const uint kept = moves && !all ? keepOthers(base, lists[neighbourCountIndex(entry)]) : 0;
    bool unlisted;
    const uint found = listNeighbours(slot, positionTexel(slot), base, kept, moves, unlisted);
    lists[neighbourCountIndex(entry)] = found;
    if (found == FLOW_NEIGHBOUR_CAPACITY) atomicAdd(counters.neighboursOverfull, 1u);
    if (!moves) return;
    if (unlisted) listWalls(base, found);
    velocity[slot].w = 0; // way that neighbours may have gone since the search
}
