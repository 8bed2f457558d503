// The surface's GPU layout: the vertices that the renderer reads, and the bindings and packings of the extraction passes.
#ifndef MELTPOOL_SHARED_SURFACE_H
#define MELTPOOL_SHARED_SURFACE_H

#include "shared/glsl_types.h"

#ifdef __cplusplus
namespace meltpool {
#endif

/// A vertex of the surface in model units.
struct SurfaceVertex {
    vec4 position; ///< xyz place, w temperature: the mean of the particles around, weighted as in the density volume
    vec4 normal;   ///< xyz outward unit normal; w the faces of the box that the vertex lies on, bits SURFACE_FACE_*
};

/// What glDrawElementsIndirect reads.
struct SurfaceDraw {
    uint count; ///< indices, three a triangle
    uint instances;
    uint firstIndex;
    uint baseVertex;
    uint baseInstance;
};

#ifdef __cplusplus
static_assert(sizeof(SurfaceVertex) == 32);
static_assert(sizeof(SurfaceDraw) == 20);
} // namespace meltpool
#endif

#endif
