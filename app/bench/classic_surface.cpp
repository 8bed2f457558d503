// The cost of the classic metal's surface by grid, influence and number of particles.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "core/metal/classic/arrangement.hpp"
#include "core/surface/surface.hpp"

namespace meltpool {

namespace {

struct Case {
    int cells;
    int influence;
    int particles;
};

/// Particles and reach of the thesis at three grids, the finest with an equal reach in space, and eight times the
/// metal.
constexpr Case kCases[] = {{32, 2, 8192}, {64, 2, 8192}, {128, 2, 8192}, {128, 4, 8192}, {128, 2, 65536}};

/// Solid cube with its upper front corner hot, so that the temperature volume has work as well.
std::vector<glm::vec4> cubeWithHotCorner(int particles) {
    ClassicSetup setup;
    setup.particles = particles;
    std::vector<glm::vec4> places = arrangeParticles(setup);
    for (glm::vec4& p : places)
        if (p.x + p.y + p.z > 0.5f) p.w = 1.0f;
    return places;
}

void measureCase(Bench& bench, const Case& what) {
    SurfaceParameters parameters;
    parameters.cells = what.cells;
    parameters.influence = what.influence;
    Surface surface(bench.shaders(), parameters, glm::vec3(-1.0f), glm::vec3(1.0f));
    const std::vector<glm::vec4> places = cubeWithHotCorner(what.particles);
    const gl::Buffer buffer("bench particles", std::span<const glm::vec4>(places));
    BenchRow row = bench.measure("surface", [&](gl::Profiler& profiler) {
        surface.update({&buffer, places.size()}, &profiler);
    });
    const SurfaceStatistics statistics = surface.statistics();
    row.particles = places.size();
    row.bytes = surface.bytes();
    row.further = {{"grid", double(what.cells)},
                   {"influence", double(what.influence)},
                   {"triangles", double(statistics.triangles)}};
    bench.add(std::move(row));
}

} // namespace

void benchClassicSurface(Bench& bench) {
    for (const Case& what : kCases)
        measureCase(bench, what);
}

} // namespace meltpool
