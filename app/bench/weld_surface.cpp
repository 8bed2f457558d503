// The cost of the surface if only a weld pool moves in a large plate: all of it rebuilt, and only the changed part.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/surface_level.hpp"

#include <glm/geometric.hpp>

#include <array>

namespace meltpool {

namespace {

constexpr float kSpacing = 0.001f;
constexpr float kPoolRadius = 0.005f;
constexpr float kThickness = 0.006f;

/// Plate of steel, its upper side at y = 0; within the pool the particles are hot and shifted by `shift` from the
/// lattice.
std::vector<glm::vec4> plate(float length, float width, float shift) {
    std::vector<glm::vec4> places;
    const auto count = [](float size) { return int(size / kSpacing + 0.5f); };
    for (int z = 0; z < count(width); ++z)
        for (int y = 0; y < count(kThickness); ++y)
            for (int x = 0; x < count(length); ++x) {
                const glm::vec3 place = (glm::vec3(x, y, z) + 0.5f) * kSpacing - glm::vec3(0, kThickness, 0);
                const bool molten = glm::distance(place, glm::vec3(length, 0.0f, width) * 0.5f) < kPoolRadius;
                places.emplace_back(place + (molten ? shift : 0.0f), molten ? 1900.0f : 300.0f);
            }
    return places;
}

void measurePlate(Bench& bench, std::string what, float length, float width, bool keep) {
    SurfaceParameters parameters;
    parameters.cells = int(length / kSpacing + 0.5f);
    parameters.influence = 3;
    parameters.kernel = int(SurfaceKernel::smooth);
    const glm::vec3 low(0.0f, -0.01f, 0.0f), high(length, 0.01f, width);
    Surface surface(bench.shaders(), parameters, low, high);
    surface.parameters.isoLevel = flatFaceLevel(parameters, surface.grid(), kSpacing);
    surface.setTemperatureRange(300.0f, 3300.0f);
    surface.incremental.enabled = keep;
    // Two states in turn: every particle of the pool changes each time.
    const std::array places{plate(length, width, 0.0f), plate(length, width, 0.3f * kSpacing)};
    const std::array buffers{gl::Buffer("bench plate", std::span<const glm::vec4>(places[0])),
                             gl::Buffer("bench plate, pool moved", std::span<const glm::vec4>(places[1]))};
    size_t turn = 0;
    BenchRow row = bench.measure(std::move(what), [&](gl::Profiler& profiler) {
        surface.update({&buffers[turn++ % 2], places[0].size()}, &profiler);
    });
    const SurfaceStatistics statistics = surface.statistics();
    row.particles = places[0].size();
    row.bytes = surface.bytes();
    row.further = {{"triangles", double(statistics.triangles)},
                   {"blocks_made", double(statistics.blocks)},
                   {"particles_entered", double(statistics.particles)}};
    bench.add(std::move(row));
}

} // namespace

void benchWeldSurface(Bench& bench) {
    measurePlate(bench, "surface, all anew", 0.1f, 0.05f, false);
    measurePlate(bench, "surface, kept", 0.1f, 0.05f, true);
    measurePlate(bench, "surface, kept, area x4", 0.2f, 0.1f, true);
}

} // namespace meltpool
