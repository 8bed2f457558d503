#include "core/surface/surface_level.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace meltpool {

double meanWeight(SurfaceKernel kernel, int influence) {
    const double reach = influence - 1;
    if (kernel == SurfaceKernel::smooth) return 64 * std::numbers::pi / 315 * std::pow(reach + 0.5, 3);
    // The offsets of the corners, over all positions of a particle, fill a cube evenly: the mean of the weight over
    // that cube, sampled in one of its eight symmetric parts.
    const double farthest = std::sqrt(3.0) / 2 + std::sqrt(3.0) * reach;
    constexpr int kPerCell = 8;
    const int across = (2 * influence - 1) * kPerCell / 2;
    double sum = 0;
    for (int z = 0; z < across; ++z)
        for (int y = 0; y < across; ++y)
            for (int x = 0; x < across; ++x)
                sum += 1 - glm::length((glm::dvec3(x, y, z) + 0.5) / double(kPerCell)) / farthest;
    return 8 * sum / (kPerCell * kPerCell * kPerCell);
}

float flatFaceLevel(const SurfaceParameters& parameters, const SurfaceGrid& grid, float spacing) {
    const glm::dvec3 cell = glm::dvec3(grid.boxMax - grid.boxMin) / glm::dvec3(grid.cells);
    const double particlesPerCell = cell.x * cell.y * cell.z / std::pow(double(spacing), 3);
    const double inside =
        meanWeight(static_cast<SurfaceKernel>(parameters.kernel), parameters.influence) * particlesPerCell;
    return static_cast<float>(0.5 * inside);
}

} // namespace meltpool
