// Ranges of particles that may be neighbours: the 27 cells around a position, or with ALL_PAIRS all particles.
#include "metal/classic/step.glsl"

// SYNCHRONOUS_DRIVER: buffer textures, because it fetches a whole texel at once, but storage component by component.
layout(binding = CLASSIC_POSITION_TEXELS) uniform samplerBuffer positionTexels;
#ifndef ALL_PAIRS
layout(binding = CLASSIC_START_TEXELS) uniform usamplerBuffer startTexels;
#endif

/// Particles of the three cells in row `row` (0 .. 8) around `cell`: first index in cell order, and the one after the
/// last. Empty outside the box.
uvec2 rangeOfRow(ivec3 cell, int row) {
#ifdef ALL_PAIRS
    return uvec2(0u, now.particles);
#else
    const int last = int(now.cellsPerAxis) - 1;
    const ivec2 yz = cell.yz + ivec2(row % 3, row / 3) - 1;
    if (any(lessThan(yz, ivec2(0))) || any(greaterThan(yz, ivec2(last)))) return uvec2(0u);
    const int first = (yz.y * (last + 1) + yz.x) * (last + 1);
    return uvec2(texelFetch(startTexels, first + max(cell.x - 1, 0)).x,
                 texelFetch(startTexels, first + min(cell.x + 1, last) + 1).x);
#endif
}

#ifdef ALL_PAIRS
const int kRows = 1;
#else
const int kRows = 9;
#endif
