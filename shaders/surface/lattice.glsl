// Flat faces of a workpiece whose metal is still on its lattice: they are those of the lattice's cells in common
// planes, with sharp edges. The volumes round both by the particles' reach, and quilt faces. Bevels and tacks are
// neither flat nor round: their cells make steps.
#ifndef MELTPOOL_SURFACE_LATTICE_GLSL
#define MELTPOOL_SURFACE_LATTICE_GLSL

#include "shared/metal.h"

layout(binding = SURFACE_TEXELS_LATTICE) uniform usamplerBuffer latticeSlots;

// Greatest distance of a face along its normal, and of its edge beside it; lattice cells. The rounding takes less.
const float kFarthestFace = 1.2;
const float kFarthestEdge = 2.0;
// Greatest distance of a pipe's face from the surface of its steps of cells.
const float kFarthestPipe = 1.0;
// Distance from the edge of a pipe's round and flat faces up to which a vertex is put on that edge.
const float kPipeEdge = 0.8;
// Share of metal off the lattice from which on no edge is searched: melted metal leaves edges in the lattice.
const float kNoneLoose = 0.01;
// Share of `flatBelow` from which on faces are no longer flat; metal melts next to them there.
const float kFlatFrom = 0.75;
// Share of `flatBelow` from which on metal off the lattice counts, if only heat distinguishes it.
const float kLooseFrom = 0.6;
// Least share of a normal along an edge of the grid that selects the face across that edge.
const float kFacing = 0.35;

bool latticeHolds(ivec3 cell) {
    if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, setup.latticeTiles * TILE_EDGE))) return false;
    ivec3 tile = cell / TILE_EDGE, inside = cell - tile * TILE_EDGE;
    int at = (tile.z * setup.latticeTiles.y + tile.y) * setup.latticeTiles.x + tile.x;
    return texelFetch(latticeSlots, at * TILE_CELLS + (inside.z * TILE_EDGE + inside.y) * TILE_EDGE + inside.x).x != 0u;
}

/// True if flat faces across `along` are in this plane: nearer than to any other plane between cells.
bool isFlatPlane(float plane, vec3 along) {
    float nearest = 1.0;
    for (int i = 0; i < setup.flatPlaneCount; ++i)
        nearest = min(nearest, abs(dot(setup.flatPlanes[i].xyz, along) - plane));
    return nearest < 0.505;
}

/// A place on a face of the lattice's metal.
struct LatticeFace {
    bool found;
    vec3 place; ///< lattice cells from the lattice's low corner
    ivec3 cell; ///< the cell of the face
};

/// The flat face nearest to `place` that looks along `axis` (an axis, or its opposite). `inner`: a little inside of the
/// place, so that a place in the plane between two cells is in the one with metal. `tries`: 3, or 0 to look for none.
/// SYNCHRONOUS_DRIVER: it skips a loop that no invocation makes, but no branch.
LatticeFace faceAt(vec3 place, vec3 inner, ivec3 axis, int tries) {
    vec3 along = abs(vec3(axis));
    int out_ = axis.x + axis.y + axis.z;
    float at = dot(place, along), best = kFarthestFace;
    ivec3 beside = ivec3(floor(inner)) * (ivec3(1) - abs(axis));
    LatticeFace face = LatticeFace(false, place, ivec3(0));
    for (int i = 0; i < tries; ++i) {
        float plane = round(at) + float(i - 1);
        ivec3 above = beside + abs(axis) * int(out_ > 0 ? plane : plane - 1.0), below = above - axis;
        float off = abs(plane - at);
        if (off >= best || !isFlatPlane(plane, along) || latticeHolds(above) || !latticeHolds(below)) continue;
        best = off;
        face = LatticeFace(true, place + along * (plane - at), below);
    }
    return face;
}

/// Moves the place on a face to the face's end along `way`, if it ends within kFarthestEdge at an edge that sticks out.
/// `tries` as in faceAt().
void moveToEdge(inout LatticeFace face, ivec3 axis, ivec3 way, int tries) {
    vec3 along = abs(vec3(way));
    float at = dot(face.place, along);
    ivec3 cell = face.cell;
    for (int i = 0; i < tries; ++i) {
        ivec3 next = cell + way;
        float plane = dot(vec3(max(cell, next)), along);
        if (abs(plane - at) > kFarthestEdge || latticeHolds(next + axis)) return; // the face goes on, or a wall rises from it
        if (!latticeHolds(next)) {
            if (isFlatPlane(plane, along)) face.place += along * (plane - at);
            return;
        }
        cell = next;
    }
}

#endif
