// The iso level at which the surface of evenly spread metal lies where the metal ends.
#pragma once

#include "core/surface/surface_grid.hpp"
#include "core/surface/surface_parameters.hpp"

namespace meltpool {

/// Sum of the weights that one particle adds to the corners, on average over its places in a cell.
double meanWeight(SurfaceKernel kernel, int influence);

/// Half of the density inside metal of one particle in each cube of `spacing` (model units): what a flat face has, for
/// weights that are symmetric. Edges and corners of the metal come out rounded by the reach of the particles.
float flatFaceLevel(const SurfaceParameters& parameters, const SurfaceGrid& grid, float spacing);

} // namespace meltpool
