// What the pass that looks for the surface around a point shares with C++.
#ifndef MELTPOOL_SHARED_SURFACE_PROBE_H
#define MELTPOOL_SHARED_SURFACE_PROBE_H

#include "glsl_types.h"

/// Rays of one look: the first along the axis, the others evenly over all directions.
#define SURFACE_PROBE_RAYS 64
#define SURFACE_BIND_PROBE 3

#ifdef __cplusplus
namespace meltpool {
#endif

/// In model units; a distance is negative inside the metal, and at least the reach where no surface was met.
struct SurfaceProbeAnswer {
    vec4 found;  // x along the axis, y nearest, z temperature where the axis meets the metal (inside: at the point), w unused
    vec4 normal; // xyz outward unit normal at the nearest place, w unused
};

#ifdef __cplusplus
static_assert(sizeof(SurfaceProbeAnswer) == 32);
} // namespace meltpool
#endif

#endif
