#version 450 core
// Lists the rows of cells of the mixed tiles that hold metal: around a bead half of the rows are empty. An invocation a
// row. list_tiles.comp lists those of the plain tiles, where no metal off the lattice comes and goes; their groups are
// counted here.
#extension GL_GOOGLE_include_directive : require
#include "shared/dispatch.h"
layout(local_size_x = GROUP_SIZE) in;
#include "metal/heat/common.glsl"
layout(std430, binding = HEAT_CONTROL) restrict buffer Control { HeatControl control; };
#include "metal/heat/listed_rows.glsl"
layout(std430, binding = HEAT_LISTED_ROWS) restrict writeonly buffer ListedRows { uint rows[]; };
layout(binding = HEAT_TEXELS_THETA_ROWS) uniform samplerBuffer thetaRows;

void main() {
    if (linearInvocation() == 0u) control.plainRows.x = (control.plainRows.w + GROUP_SIZE - 1u) / GROUP_SIZE;
    const uint place = linearInvocation() / TILE_ROWS;
    if (place >= control.mixedTiles.w) return;
    const uint listed = texelFetch(listTexels, int(place)).x;
    const bool reached = (listed & HEAT_REACHED) != 0u;
    const int tile = int(listed & ~HEAT_REACHED);
    const int row = int(gl_LocalInvocationIndex % TILE_ROWS);
    const vec4 theta = texelFetch(thetaRows, thetaBase(stampOf(tile), tile) / TILE_EDGE + row);
    // Former metal of the lattice may be left in the other half.
    if (all(equal(theta, vec4(kEmpty))) && (rowBitsOf(tile) >> row & 1u) == 0u) return;
    const uint entry = reached ? atomicAdd(control.reachedRows.w, 1u) : atomicAdd(control.unreachedRows.w, 1u);
    rows[placeOfMixed(reached, entry)] = uint(TILE_ROWS * tile + row);
    if (entry % (GROUP_SIZE / TILE_EDGE) != 0u) return;
    atomicAdd(control.mixedRows.x, 1u);
    if (reached)
        atomicAdd(control.reachedRows.x, 1u);
    else
        atomicAdd(control.unreachedRows.x, 1u);
}
