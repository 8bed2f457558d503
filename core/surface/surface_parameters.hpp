// Parameters of the surface: cells of the grid, reach and kernel of a particle, iso level, caps.
#pragma once

#include "core/base/parameter.hpp"

namespace meltpool {

/// Weight of a particle at a corner at distance d.
enum class SurfaceKernel : int {
    cone,   ///< founding thesis: 1 - d / d_max, not zero at the farthest corners that it reaches
    smooth, ///< (1 - d² / r²)³ with r = influence - 1/2 cells, zero at r: smoother, steadier surfaces; influence >= 2
};

struct SurfaceParameters {
    int cells = 64;     ///< grid cells along the longest side of the box
    int influence = 2;  ///< a particle adds to the (2 influence - 1)³ corners around its nearest one
    float isoLevel = 1; ///< corners whose density is at least this are inside
    bool caps = true;   ///< closes the surface where the metal touches the box
    int kernel = int(SurfaceKernel::cone); ///< a SurfaceKernel
};

/// Returns the description for menus, files and `--set`; the pointers point into `parameters`.
ParameterList describe(SurfaceParameters& parameters);

} // namespace meltpool
