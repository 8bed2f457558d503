#include "core/training/trainer/body_mesh.hpp"

#include "core/surface/mesh_bodies.hpp"

#include <glm/geometric.hpp>
#include <glm/gtx/component_wise.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

/// Edge of a grid cell in particle spacings. A particle of influence 3 reaches 2.5 cells, 1.75 spacings: from 1.1 on
/// the middle between eight particles of a lattice is inside, and metal that froze in disorder needs more. The farther
/// the reach, the rounder the edges.
constexpr float kCellSpacings = 0.7F;
constexpr int kInfluence = 3;
/// Limit above which the grid becomes coarser: its volumes take 12 bytes a corner.
constexpr float kMostCorners = 32e6F;
constexpr float kFewestCells = 2, kMostCells = 1000;

} // namespace

SurfaceParameters bodySurface(float spacing, glm::vec3 boxMin, glm::vec3 boxMax) {
    const glm::vec3 size = boxMax - boxMin;
    const float cell = std::max(kCellSpacings * spacing, std::cbrt(size.x * size.y * size.z / kMostCorners));
    SurfaceParameters parameters;
    parameters.cells = static_cast<int>(std::clamp(std::round(glm::compMax(size) / cell), kFewestCells, kMostCells));
    parameters.influence = kInfluence;
    parameters.kernel = static_cast<int>(SurfaceKernel::smooth);
    return parameters;
}

MeshCopy bodyMesh(gl::ShaderLibrary& shaders, const LessonMetal& metal, const SurfaceParameters& shown) {
    const SceneView scene = metal.model().makeScene()->view({});
    SurfaceParameters parameters = shown;
    if (const auto spacing = metal.model().spacing()) parameters = bodySurface(*spacing, scene.boxMin, scene.boxMax);
    parameters.caps = true;
    Surface surface(shaders, parameters, scene.boxMin, scene.boxMax);
    metal.model().prepare(surface);
    surface.incremental = {};
    ParticleView particles = metal.particles();
    particles.frozenAt = nullptr; // files have no ripples
    surface.update(particles, nullptr);
    MeshCopy mesh = outerBodies(copyMesh(surface));
    const glm::mat3 turn = glm::mat3(scene.modelToWorld) / glm::length(glm::vec3(scene.modelToWorld[0]));
    for (SurfaceVertex& vertex : mesh.vertices) {
        vertex.position = turn * vertex.position * metal.model().unit();
        vertex.normal = turn * vertex.normal;
    }
    return mesh;
}

} // namespace meltpool
