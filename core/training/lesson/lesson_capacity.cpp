#include "core/training/lesson/lesson_capacity.hpp"

#include "core/base/error.hpp"
#include "core/metal/physical_metal.hpp"
#include "core/surface/surface_grid.hpp"

namespace meltpool {

namespace {

constexpr double kSurfaceBlockBytes = 56.0 * 512; ///< bytes of 8³ corners, with the usual mesh across them

double surfaceBytes(const Lesson& lesson, const glm::vec3& low, const glm::vec3& high) {
    return static_cast<double>(SurfaceGrid(lesson.surface.cells, low, high).blockCount()) * kSurfaceBlockBytes;
}

MetalSize sizeOf(const Lesson& lesson) {
    MetalSize size;
    if (lesson.model == LessonModel::Classic) {
        size.particles = lesson.setup.particles;
        size.otherBytes = surfaceBytes(lesson, glm::vec3(-1), glm::vec3(1));
        return size;
    }
    const Workpiece piece = makeWorkpiece(lesson.workpiece);
    const glm::ivec3 cells = piece.lattice.cells();
    size.heatCells = static_cast<double>(cells.x) * cells.y * cells.z;
    size.particles = static_cast<double>(piece.seeds.size() + PhysicalSetup().fillerRoom);
    size.flowParticles = size.particles;
    size.flowVolume = size.heatCells;
    size.otherBytes = surfaceBytes(lesson, piece.low, piece.high);
    return size;
}

} // namespace

void requireCapacity(const Lesson& lesson, const MetalCapacity& room) {
    const std::string fault = capacityFault(sizeOf(lesson), room);
    if (fault.empty()) return;
    const bool classic = lesson.model == LessonModel::Classic;
    throw InputError("the lesson " + lesson.key + " " + fault + "; expected " +
                     (classic ? "fewer particles" : "a larger spacing_mm or a smaller workpiece"));
}

} // namespace meltpool
