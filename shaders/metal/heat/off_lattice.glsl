// Metal off the lattice and the cells: the distribution of a particle's eight shares (cloud in cell). Included after
// common.glsl.
//
// A particle off the lattice belongs to the eight cells around it with trilinear weights; a particle of the lattice to
// its own cell with weight 1. A cell has the weighted mean of the Kirchhoff variable, cells exchange heat as on the
// lattice, and a cell's gain goes back to its particles by the same weights. Every exchange is between two cells or
// between a cell and its own particles, so nothing is gained or lost.

/// Slot number `entry` of the list of those off the lattice.
uint offLatticeSlot(uint entry) { return texelFetch(listTexels, offLatticeSlotsBegin() + int(entry)).x; }

struct Shares {
    ivec3 base;    // lowest of the eight cells
    vec3 fraction; // share of the way to the highest
};

Shares sharesOf(vec3 place) {
    vec3 q = (place - metal.origin) / metal.spacing - 0.5;
    vec3 low = floor(q);
    return Shares(ivec3(low), q - low);
}

/// Cell `corner` (0 .. 7) of the shares and its weight, a whole number of 1/SHARE_UNIT; -1 if it is off the lattice.
int shareCell(Shares s, int corner, out float weight) {
    ivec3 bit = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    ivec3 cell = s.base + bit;
    vec3 w = mix(1.0 - s.fraction, s.fraction, vec3(bit));
    weight = floor(w.x * w.y * w.z * float(SHARE_UNIT)) / float(SHARE_UNIT);
    if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, metal.tiles * TILE_EDGE))) return -1;
    ivec3 tile = cell / TILE_EDGE;
    ivec3 inside = cell - tile * TILE_EDGE;
    return tileIndex(tile) * TILE_CELLS + (inside.z * TILE_EDGE + inside.y) * TILE_EDGE + inside.x;
}
