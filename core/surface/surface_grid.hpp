// The grid of the surface extraction: its cells over the box and the storage of its corners.
#pragma once

#include "shaders/shared/surface.h"

#include <glm/vec3.hpp>

#include <cstddef>

namespace meltpool {

/// A grid whose corners of an axis are numbered from 0 to cells + 2; the first and the last are in the empty layer
/// around the grid (shaders/shared/surface.h). z runs against the model's: corner 1 is at boxMax.z, as in the founding
/// thesis.
struct SurfaceGrid {
    glm::ivec3 cells{1};
    glm::vec3 boxMin{-1.0f};
    glm::vec3 boxMax{1.0f};

    /// Makes a grid of `cells` along the longest side of the box; along the others as many as make the cells most
    /// nearly cubes, at least 2. Throws InputError when the box has no volume, or when `cells` does not fit the packed
    /// coordinates.
    SurfaceGrid(int cells, glm::vec3 boxMin, glm::vec3 boxMax);

    /// Returns the number of blocks of 8³ corners along each axis.
    glm::ivec3 blocks() const { return (cells + 2 + (SURFACE_BLOCK - 1)) / SURFACE_BLOCK; }
    size_t blockCount() const;

    /// Returns the index of a corner in the volumes; equal to cornerAddress() in the shaders.
    size_t address(glm::ivec3 corner) const;

    /// Returns the size of the mesh buffers: twelve layers of surface across the whole grid, or all edges of a small
    /// grid. A welded plate or a melting cube has one or two layers.
    size_t mostVertices() const;
    size_t mostTriangles() const { return 2 * mostVertices(); }

    /// Returns the uniform block of the passes with the values that the grid decides; temperatures 0..1, the rest 0.
    SurfaceSetup setup() const;
};

} // namespace meltpool
