// Definitions that the painter of flying drops and of smoke shares with its shaders.
#ifndef MELTPOOL_SHARED_EFFECTS_H
#define MELTPOOL_SHARED_EFFECTS_H

#include "glsl_types.h"

// Storage bindings of the drops, and of the puffs of smoke.
#define SPARKS_BINDING 3
#define FUME_BINDING 6

#ifdef __cplusplus
namespace meltpool {
#endif

/// A glowing ball, drawn out along its way.
struct Spark {
    vec3 place;   // model units
    float radius; // model units
    vec3 way;     // way while the eye gathers a picture, model units; 0 for a drop at rest or hanging
    float kelvin;
};

/// A puff of smoke: an egg, drawn out along its way.
struct FumePuff {
    vec3 place;   // middle, model units
    float radius; // radius across its way, model units
    vec3 way;     // half its length along its way, model units; no shorter than the radius
    float depth;  // optical depth for scattered light as seen from beside its way, mean over the ellipse
    vec3 grain;   // the place in the noise at its middle, texels
    float reserved;
};

#ifdef __cplusplus
static_assert(sizeof(Spark) == 32);
static_assert(sizeof(FumePuff) == 48);
} // namespace meltpool
#endif

#endif
