#version 450 core
// Lists the tiles that take part in this step, among those that ever held metal: active tiles, their neighbours, those
// that a source reaches and those with metal off the lattice. A sleeping tile with a warm surface takes part every
// TILE_LOSS_INTERVAL steps.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
layout(std430, binding = HEAT_LISTS) restrict writeonly buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_LISTED_ROWS) restrict writeonly buffer ListedRows { uint rows[]; };
layout(std430, binding = HEAT_CONTROL) restrict buffer Control { HeatControl control; };

bool isAwake(TileNotes notes) { return heatBlock.stepNumber - notes.lastActive <= TILE_AWAKE_STEPS; }
bool holdsOffLattice(TileNotes notes) { return notes.lastOffLattice == heatBlock.stepNumber; }

bool underSource(ivec3 place) { return nextReaching(place, 0) < heatBlock.sourceCount; }

/// Activity in a tile's neighbours, and metal off the lattice in them.
struct Neighbourhood {
    bool awake, offLattice;
};

Neighbourhood neighbourhoodOf(int tile, ivec3 place) {
    Neighbourhood found = Neighbourhood(false, false);
    ivec3 stride = ivec3(1, metal.tiles.x, metal.tiles.x * metal.tiles.y);
    for (int axis = 0; axis < 3; ++axis)
        for (int side = -1; side <= 1; side += 2) {
            int there = place[axis] + side;
            if (there < 0 || there >= metal.tiles[axis]) continue;
            TileNotes notes = notesOf(tile + side * stride[axis]);
            found.awake = found.awake || isAwake(notes);
            found.offLattice = found.offLattice || holdsOffLattice(notes);
        }
    return found;
}

/// Simulated time since a tile last took part, this step included, s.
float elapsedSinceStep(int tile, int stamp) {
    if (tookPart(stamp, heatBlock.stepNumber - 1)) return heatBlock.timeStep;
    return float(heatBlock.endTime - tiles[tile].endTime) * 1e-6;
}

/// Lists a tile's rows. Their groups are counted after all are listed.
void listPlainRows(int tile, uint rowBits) {
    uint place = atomicAdd(control.plainRows.w, uint(bitCount(rowBits)));
    for (uint left = rowBits; left != 0u; left &= left - 1u) rows[place++] = uint(TILE_ROWS * tile + findLSB(left));
}

void listMixed(int tile, bool reached) {
    const uint entry = atomicAdd(control.mixedTiles.w, 1u);
    if (entry > 0u && entry % (GROUP_SIZE / TILE_ROWS) == 0u) atomicAdd(control.mixedTiles.x, 1u);
    lists[entry] = uint(tile) | (reached ? HEAT_REACHED : 0u);
}

void main() {
    uint known = linearInvocation();
    if (known >= control.metalTileCount) return;
    int tile = int(texelFetch(listTexels, metalTilesBegin() + int(known)).x);
    int stamp = stampOf(tile);
    TileNotes notes = notesOf(tile);
    bool offLattice = holdsOffLattice(notes);
    ivec3 place = tileCoordinate(tile);
    Neighbourhood neighbours = neighbourhoodOf(tile, place);
    bool source = underSource(place);
    bool warm = (stamp >> TILE_STEP_SHIFT) - notes.lastWarm < TILE_NOTE_INTERVAL;
    bool losesHeat = warm && (heatBlock.stepNumber + tile) % TILE_LOSS_INTERVAL == 0;
    int half_ = (stamp ^ (stamp >> 1)) & TILE_HALF; // a plain step changed halves
    bool awake = isAwake(notes) || neighbours.awake || neighbours.offLattice;
    if (!(losesHeat || offLattice || source || awake)) {
        if ((stamp & TILE_PLAIN) != 0) tileStamp[tile] = (stamp & ~(TILE_PLAIN | TILE_HALF)) | half_;
        return;
    }
    bool mixed = offLattice || neighbours.offLattice || source;
#ifdef EVAPORATION
    mixed = mixed || heatBlock.stepNumber - notes.lastEvaporating <= TILE_AWAKE_STEPS;
#endif
    tiles[tile].elapsed = elapsedSinceStep(tile, stamp);
    tiles[tile].endTime = heatBlock.endTime;
    tileStamp[tile] = heatBlock.stepNumber << TILE_STEP_SHIFT | (offLattice ? TILE_SHARED : 0) | (mixed ? 0 : TILE_PLAIN) | half_;
    if (mixed)
        listMixed(tile, source);
    else
        listPlainRows(tile, rowBitsOf(tile));
    if (offLattice) lists[offLatticeTilesBegin() + int(atomicAdd(control.offLatticeTiles.x, 1u))] = uint(tile);
}
