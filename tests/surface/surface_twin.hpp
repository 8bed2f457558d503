// A CPU twin of the surface in its simplest form, and measures of triangle meshes.
#pragma once

#include "core/surface/surface.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace meltpool::test {

struct Volumes {
    std::vector<std::uint32_t> density;     ///< indexed by SurfaceGrid::address()
    std::vector<std::uint32_t> temperature; ///< indexed likewise
};

/// Returns the volumes that Surface::update() makes, with each weight's operations in its order.
Volumes twinVolumes(const SurfaceGrid& grid, const SurfaceParameters& parameters, float coldest, float hottest,
                    const std::vector<glm::vec4>& particles);

/// Returns the freezing volume likewise. `frozenAt` has one time (s) per particle; 0: never melted, negative: molten.
std::vector<glm::uvec2> twinFreezing(const SurfaceGrid& grid, const SurfaceParameters& parameters,
                                     const std::vector<glm::vec4>& particles, const std::vector<float>& frozenAt);

struct Mesh {
    std::vector<SurfaceVertex> vertices;
    std::vector<unsigned> indices;
};

/// Applies marching cubes to every cell of the grid (and of the layer around it with caps), with vertices shared by
/// edge, in the order that Surface promises.
Mesh twinMesh(const SurfaceGrid& grid, const Volumes& volumes, const SurfaceParameters& parameters, float coldest,
              float hottest);

/// Returns the mesh of the last update, without empty triangles.
Mesh readMesh(const Surface& surface);

/// Returns the sides that are not shared by exactly two triangles in opposite directions, as pairs of vertex numbers.
std::vector<std::pair<unsigned, unsigned>> unmatchedSides(const Mesh& mesh);

/// Return the area, and the volume that outward-turned triangles enclose.
double meshArea(const Mesh& mesh);
double meshVolume(const Mesh& mesh);

} // namespace meltpool::test
