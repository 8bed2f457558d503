#include "core/surface/surface_grid.hpp"

#include "core/base/error.hpp"

#include <glm/common.hpp>
#include <glm/gtx/component_wise.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <string>

namespace meltpool {

SurfaceGrid::SurfaceGrid(int cellsAlong, glm::vec3 low, glm::vec3 high) : boxMin(low), boxMax(high) {
    const glm::vec3 size = high - low;
    constexpr int kMostCells = (1 << SURFACE_COORDINATE_BITS) - 4;
    if (cellsAlong < 2 || cellsAlong > kMostCells)
        throw InputError("the surface grid has " + std::to_string(cellsAlong) + " cells; expected 2 to " +
                         std::to_string(kMostCells));
    if (!glm::all(glm::greaterThan(size, glm::vec3(0.0f))))
        throw InputError("the box of the surface grid is empty; expected a positive size along every axis");
    const float longest = glm::compMax(size);
    cells = glm::max(glm::ivec3(glm::round(size * (float(cellsAlong) / longest))), glm::ivec3(2));
}

size_t SurfaceGrid::blockCount() const {
    const glm::ivec3 b = blocks();
    return size_t(b.x) * size_t(b.y) * size_t(b.z);
}

size_t SurfaceGrid::address(glm::ivec3 corner) const {
    const glm::ivec3 block = corner / SURFACE_BLOCK, inner = corner % SURFACE_BLOCK, b = blocks();
    return ((size_t(block.z) * size_t(b.y) + size_t(block.y)) * size_t(b.x) + size_t(block.x)) * SURFACE_BLOCK_CORNERS +
           size_t(inner.z * 64 + inner.y * 8 + inner.x);
}

size_t SurfaceGrid::mostVertices() const {
    const glm::ivec3 c = cells + 3;
    const size_t all = 3 * size_t(c.x) * size_t(c.y) * size_t(c.z);
    const size_t layer = size_t(c.x) * size_t(c.y) + size_t(c.y) * size_t(c.z) + size_t(c.z) * size_t(c.x);
    // Most vertices for which one row of work groups makes all triangles.
    constexpr size_t kOneDispatch = 65535 * size_t(SURFACE_GROUP) / 2;
    return std::min({all, 12 * layer, kOneDispatch});
}

SurfaceSetup SurfaceGrid::setup() const {
    SurfaceSetup setup{};
    setup.cells = cells;
    setup.blocks = blocks();
    setup.blockCount = static_cast<int>(blockCount());
    setup.origin = glm::vec3(boxMin.x, boxMin.y, boxMax.z);
    setup.extent = glm::vec3(boxMax.x - boxMin.x, boxMax.y - boxMin.y, boxMin.z - boxMax.z);
    setup.coldest = 0;
    setup.temperatureRange = 1;
    setup.maxVertices = static_cast<unsigned>(mostVertices());
    setup.maxTriangles = static_cast<unsigned>(mostTriangles());
    return setup;
}

} // namespace meltpool
