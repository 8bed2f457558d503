// Definitions that the pass which finds the surface around a point shares with C++.
#ifndef MELTPOOL_SHARED_SURFACE_PROBE_H
#define MELTPOOL_SHARED_SURFACE_PROBE_H

#include "glsl_types.h"

/// Rays of one query: the first along the axis, the others spread evenly over all directions.
#define SURFACE_PROBE_RAYS 64
#define SURFACE_BIND_PROBE 3

#ifdef __cplusplus
namespace meltpool {
#endif

/// The surface around a point, in model units. A distance is negative if the point is inside the metal, and equals the
/// query's reach if no surface was found.
struct SurfaceProbeAnswer {
    vec3 normal;       ///< outward unit normal at the nearest place
    float ahead;       ///< distance along the axis; from inside the metal: against the axis
    float nearest;     ///< least distance over all rays: before a flat face up to a tenth too long
    float temperature; ///< temperature at the metal on the axis (from inside: at the point), as the surface shows it
    vec2 reserved;
};

#ifdef __cplusplus
static_assert(sizeof(SurfaceProbeAnswer) == 32);
} // namespace meltpool
#endif

#endif
