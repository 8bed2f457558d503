// The iso level that puts the surface of evenly spaced particles at the end of their metal.
#pragma once

#include "core/surface/surface_grid.hpp"
#include "core/surface/surface_parameters.hpp"

namespace meltpool {

/// Returns the sum of the weights that one particle adds to the corners, averaged over its positions in a cell.
double meanWeight(SurfaceKernel kernel, int influence);

/// Returns half of the density inside metal with one particle in each cube of edge `spacing` (model units): the density
/// at a flat face, as the weights are symmetric. Edges and corners of the metal appear rounded by the reach of the
/// particles.
float flatFaceLevel(const SurfaceParameters& parameters, const SurfaceGrid& grid, float spacing);

} // namespace meltpool
