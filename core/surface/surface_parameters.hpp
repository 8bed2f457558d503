// What can be chosen about the surface: fineness of the grid, reach of a particle, iso level, caps.
#pragma once

#include "core/base/parameter.hpp"

namespace meltpool {

struct SurfaceParameters {
    int cells = 64;     ///< grid cells along the longest side of the box
    int influence = 2;  ///< a particle adds to the (2 influence - 1)³ corners around its nearest one
    float isoLevel = 1; ///< a corner is inside where the density volume reaches this
    bool caps = true;   ///< close the surface where the metal touches the box
};

/// The one description that menus, files and `--set` are made from. The pointers point into `parameters`.
ParameterList describe(SurfaceParameters& parameters);

} // namespace meltpool
