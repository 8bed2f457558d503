// The surface computed on the CPU in the simplest way, and measures of triangle meshes.
#pragma once

#include "core/surface/surface.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace meltpool::test {

struct Volumes {
    std::vector<std::uint32_t> density;     ///< by SurfaceGrid::address()
    std::vector<std::uint32_t> temperature; ///< likewise
};

/// The volumes that Surface::update() makes, in the same order of operations of each weight.
Volumes twinVolumes(const SurfaceGrid& grid, const SurfaceParameters& parameters, float coldest, float hottest,
                    const std::vector<glm::vec4>& particles);

/// The freezing volume likewise; `frozenAt`: s, a particle each; 0: it never melted, negative: it is
/// molten.
std::vector<glm::uvec2> twinFreezing(const SurfaceGrid& grid, const SurfaceParameters& parameters,
                                     const std::vector<glm::vec4>& particles, const std::vector<float>& frozenAt);

struct Mesh {
    std::vector<SurfaceVertex> vertices;
    std::vector<unsigned> indices;
};

/// Marching cubes over every cell of the grid (and of the layer around it with caps), vertices shared by edge; in the
/// order that Surface promises.
Mesh twinMesh(const SurfaceGrid& grid, const Volumes& volumes, const SurfaceParameters& parameters, float coldest,
              float hottest);

/// The mesh of the last update, without empty triangles.
Mesh readMesh(const Surface& surface);

/// The sides that are not shared by exactly two triangles in opposite directions, as pairs of vertex numbers.
std::vector<std::pair<unsigned, unsigned>> unmatchedSides(const Mesh& mesh);

/// Area, and volume enclosed by outward-turned triangles.
double meshArea(const Mesh& mesh);
double meshVolume(const Mesh& mesh);

} // namespace meltpool::test
