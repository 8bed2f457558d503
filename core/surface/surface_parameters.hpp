// What can be chosen about the surface: fineness of the grid, reach of a particle, iso level, caps.
#pragma once

#include "core/base/parameter.hpp"

namespace meltpool {

/// How a particle's weight falls with the distance d to a corner.
enum class SurfaceKernel : int {
    cone,   ///< the founding thesis': 1 - d / d_max, cut off in a step at the reached corners
    smooth, ///< (1 - d² / r²)³ with r = influence - 1/2 cells: no step, for smooth and steady surfaces; influence >= 2
};

struct SurfaceParameters {
    int cells = 64;     ///< grid cells along the longest side of the box
    int influence = 2;  ///< a particle adds to the (2 influence - 1)³ corners around its nearest one
    float isoLevel = 1; ///< a corner is inside where the density volume reaches this
    bool caps = true;   ///< close the surface where the metal touches the box
    int kernel = int(SurfaceKernel::cone); ///< a SurfaceKernel
};

/// The one description that menus, files and `--set` are made from. The pointers point into `parameters`.
ParameterList describe(SurfaceParameters& parameters);

} // namespace meltpool
