// Adds to the list of tiles that ever held metal. Included after common.glsl.
layout(std430, binding = HEAT_LISTS) restrict buffer Lists { uint lists[]; };
layout(std430, binding = HEAT_CONTROL) restrict buffer Control { HeatControl control; };

/// Lists a tile. Call it once a tile.
void listMetalTile(int tile) {
    uint entry = atomicAdd(control.metalTileCount, 1u);
    if (entry % GROUP_SIZE == 0u) atomicAdd(control.metalTileGroups.x, 1u);
    lists[metalTilesBegin() + int(entry)] = uint(tile);
}
