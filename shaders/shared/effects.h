// What the painter of flying drops shares with its shaders.
#ifndef MELTPOOL_SHARED_EFFECTS_H
#define MELTPOOL_SHARED_EFFECTS_H

#include "glsl_types.h"

// Storage binding of the drops.
#define SPARKS_BINDING 3

#ifdef __cplusplus
namespace meltpool {
#endif

/// A glowing ball, drawn out along its way.
struct Spark {
    vec3 place;   // model units
    float radius; // model units
    vec3 way;     // how far it flies while the eye gathers a picture, model units; 0 where it lies or hangs
    float kelvin;
};

#ifdef __cplusplus
static_assert(sizeof(Spark) == 32);
} // namespace meltpool
#endif

#endif
