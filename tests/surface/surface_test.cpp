// The surface's passes against their twin on the CPU, closed meshes, and shapes of known measures.
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/surface/surface_twin.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace meltpool {

using glm::ivec3;
using glm::vec3;
using glm::vec4;

namespace {

using Particles = std::vector<vec4>;

void updateWith(Surface& surface, const Particles& particles) {
    const gl::Buffer buffer("particles", std::span<const vec4>(particles));
    surface.update({&buffer, particles.size()}, nullptr);
    glFinish();
}

/// Returns uniform particles in the box and a little beyond it, temperatures from 0 to 1.
Particles scattered(size_t count, vec3 low, vec3 high, unsigned seed) {
    std::mt19937 random(seed);
    const auto next = [&random] { return float(random() >> 8) * 0x1p-24f; };
    Particles particles(count);
    for (vec4& p : particles)
        p = vec4(low + (high - low) * (vec3(next(), next(), next()) * 1.2f - 0.1f), next());
    return particles;
}

/// Returns a particle exactly on each corner that `take` accepts: with influence 1 the density there is exactly 1, else
/// 0.
template <class Take>
Particles onCorners(const SurfaceGrid& grid, Take take) {
    const SurfaceSetup s = grid.setup();
    Particles particles;
    for (int z = 1; z <= grid.cells.z + 1; ++z)
        for (int y = 1; y <= grid.cells.y + 1; ++y)
            for (int x = 1; x <= grid.cells.x + 1; ++x)
                if (take(ivec3(x, y, z)))
                    particles.emplace_back(s.origin + s.extent * (vec3(ivec3(x, y, z) - 1) / vec3(grid.cells)), 0.5f);
    return particles;
}

Particles randomPattern(const SurfaceGrid& grid, unsigned percent, unsigned seed) {
    std::mt19937 random(seed);
    return onCorners(grid, [&](ivec3) { return random() % 100 < percent; });
}

void requireVolumes(const Surface& surface, const test::Volumes& twin) {
    REQUIRE(surface.densityVolume().read<std::uint32_t>(twin.density.size()) == twin.density);
    REQUIRE(surface.temperatureVolume().read<std::uint32_t>(twin.density.size()) == twin.temperature);
}

/// Returns the largest difference of a coordinate, normal component or temperature.
double largestDifference(const std::vector<SurfaceVertex>& a, const std::vector<SurfaceVertex>& b) {
    double largest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        largest = std::max(largest, double(std::abs(a[i].temperature - b[i].temperature)));
        for (int j = 0; j < 3; ++j) {
            largest = std::max(largest, double(std::abs(a[i].position[j] - b[i].position[j])));
            largest = std::max(largest, double(std::abs(a[i].normal[j] - b[i].normal[j])));
        }
    }
    return largest;
}

} // namespace

TEST_CASE("the volumes equal the twin's to the last unit at every influence and odd sizes") {
    const float notANumber = std::numeric_limits<float>::quiet_NaN();
    for (const auto& [cells, influence, count] : {std::array{2, 1, 1},
                                                  {2, 8, 63},
                                                  {3, 2, 65},
                                                  {7, 3, 500},
                                                  {13, 2, 1234},
                                                  {21, 4, 300},
                                                  {33, 5, 100},
                                                  {17, 6, 65},
                                                  {31, 7, 64},
                                                  {16, 1, 1234},
                                                  {64, 2, 8192}}) {
        const vec3 low(-1.0f, -0.5f, 0.25f), high(1.0f, 0.75f, 1.5f);
        Surface surface(test::shaders(), {cells, influence}, low, high);
        Particles particles = scattered(size_t(count), low, high, unsigned(cells));
        particles.emplace_back(low, 1.0f);
        particles.emplace_back(high, 0.0f);
        particles.emplace_back(notANumber, 0.0f, 0.5f, 0.5f);
        particles.emplace_back(0.0f, 1e30f, 0.5f, 0.5f);
        particles.emplace_back(0.0f, 0.0f, 0.5f, notANumber);
        updateWith(surface, particles);
        const test::Volumes twin = test::twinVolumes(surface.grid(), surface.parameters, 0, 1, particles);
        INFO("cells " << cells << ", influence " << influence);
        requireVolumes(surface, twin);
        surface.parameters.kernel = int(SurfaceKernel::smooth);
        updateWith(surface, particles);
        requireVolumes(surface, test::twinVolumes(surface.grid(), surface.parameters, 0, 1, particles));
    }
}

TEST_CASE("a particle reaches (2 influence - 1) cubed corners and weighs by distance") {
    for (int influence = 1; influence <= 8; ++influence) {
        Surface surface(test::shaders(), {20, influence}, vec3(-1), vec3(1));
        updateWith(surface, {vec4(0.0f, 0.0f, 0.0f, 0.0f)}); // particle on a corner
        const auto volume = surface.densityVolume().read<std::uint32_t>(surface.densityVolume().bytes() / 4);
        const auto reached = std::count_if(volume.begin(), volume.end(), [](std::uint32_t v) { return v > 0; });
        CHECK(reached == (2 * influence - 1) * (2 * influence - 1) * (2 * influence - 1));
        CHECK(volume[surface.grid().address(ivec3(11))] == SURFACE_UNIT);
        const double farthest = std::sqrt(3.0) / 2 + std::sqrt(3.0) * (influence - 1);
        if (influence > 1) {
            CHECK(double(volume[surface.grid().address({12, 11, 11})]) == Approx(1e4 * (1 - 1 / farthest)).margin(1));
        }
    }
}

TEST_CASE("the z axis of the grid runs against the model's") {
    Surface surface(test::shaders(), {8, 1}, vec3(-1), vec3(1));
    updateWith(surface, {vec4(-1.0f, 0.0f, 1.0f, 0.0f)});
    const auto volume = surface.densityVolume().read<std::uint32_t>(surface.densityVolume().bytes() / 4);
    CHECK(volume[surface.grid().address({1, 5, 1})] == SURFACE_UNIT);
}

TEST_CASE("the mesh equals the twin's, vertex by vertex and triangle by triangle") {
    for (const auto& [cells, influence, count] :
         {std::array{2, 1, 40}, {5, 1, 300}, {9, 2, 200}, {23, 2, 700}, {14, 3, 90}})
        for (const bool caps : {true, false}) {
            const vec3 low(-0.3f, -1.0f, 0.5f), high(0.5f, 1.0f, 1.5f);
            Surface surface(test::shaders(), {cells, influence, 1.0f, caps}, low, high);
            surface.setTemperatureRange(-1.0f, 3.0f);
            const Particles particles = scattered(size_t(count), low, high, 7);
            updateWith(surface, particles);
            const test::Volumes volumes = test::twinVolumes(surface.grid(), surface.parameters, -1, 3, particles);
            const test::Mesh twin = test::twinMesh(surface.grid(), volumes, surface.parameters, -1, 3);
            const test::Mesh mesh = test::readMesh(surface);
            INFO("cells " << cells << ", influence " << influence << ", caps " << caps);
            REQUIRE(twin.indices.size() > 0);
            REQUIRE(mesh.indices == twin.indices);
            REQUIRE(largestDifference(mesh.vertices, twin.vertices) < 1e-3);
        }
}

TEST_CASE("the surface of any pattern is closed with caps, and open only at the box without") {
    unsigned seed = 1;
    for (const int cells : {2, 3, 5, 6, 7, 14, 15, 22})
        for (const unsigned percent : {10U, 50U, 90U, 100U}) {
            ++seed; // at iso level 1 every vertex is on a corner: the hardest case for the faces' agreement
            Surface surface(test::shaders(), {cells, 1, seed % 2 == 0 ? 1.0f : 0.3f}, vec3(-1), vec3(1));
            const Particles particles = randomPattern(surface.grid(), percent, seed);
            INFO("cells " << cells << ", percent " << percent << ", particles " << particles.size());
            updateWith(surface, particles);
            test::Mesh mesh = test::readMesh(surface);
            REQUIRE(mesh.indices.size() == size_t(surface.statistics().triangles) * 3);
            REQUIRE_FALSE(surface.statistics().overflow);
            REQUIRE(test::unmatchedSides(mesh).empty());
            if (percent == 100) {
                CHECK(test::meshVolume(mesh) == Approx(8.0));
                CHECK(test::meshArea(mesh) == Approx(24.0));
            }

            surface.parameters.caps = false;
            updateWith(surface, particles);
            mesh = test::readMesh(surface);
            size_t inTheMiddle = 0;
            for (const auto& [a, b] : test::unmatchedSides(mesh)) {
                const vec3 p = mesh.vertices[a].position, q = mesh.vertices[b].position;
                bool onBox = false;
                for (int axis = 0; axis < 3; ++axis)
                    onBox |= std::abs(std::abs(p[axis]) - 1) < 1e-6f && std::abs(p[axis] - q[axis]) < 1e-6f;
                inTheMiddle += !onBox;
            }
            CHECK(inTheMiddle == 0);
            CHECK((percent != 100 || mesh.indices.empty()));
        }
}

TEST_CASE("all 256 patterns of a cell give a closed surface") {
    for (unsigned inside = 1; inside < 256; ++inside) {
        Surface surface(test::shaders(), {4, 1, 0.5f}, vec3(-1), vec3(1));
        updateWith(surface, onCorners(surface.grid(), [inside](ivec3 c) {
                       const ivec3 d = c - 2;
                       return glm::all(glm::equal(d & 1, d)) && (inside >> (d.x + 2 * d.y + 4 * d.z) & 1U) != 0;
                   }));
        const test::Mesh mesh = test::readMesh(surface);
        REQUIRE(mesh.indices.size() > 0);
        REQUIRE(test::unmatchedSides(mesh).empty());
        REQUIRE(test::meshVolume(mesh) > 0);
    }
}

TEST_CASE("a ball has its area, volume, topology and normals") {
    // One particle has influence 8: the density falls linearly with the distance, so that every level is a sphere.
    Surface surface(test::shaders(), {32, 8, 0.6f}, vec3(-1), vec3(1));
    const vec3 centre(0.013f, -0.021f, 0.008f);
    updateWith(surface, {vec4(centre, 0.0f)});
    const test::Mesh mesh = test::readMesh(surface);
    const double radius = 0.4 * (std::sqrt(3.0) / 2 + 7 * std::sqrt(3.0)) * 2 / 32;
    constexpr double kPi = 3.14159265358979;
    CHECK(test::unmatchedSides(mesh).empty());
    CHECK(mesh.vertices.size() + mesh.indices.size() / 3 == mesh.indices.size() / 2 + 2); // Euler's formula
    CHECK(test::meshArea(mesh) == Approx(4 * kPi * radius * radius).epsilon(0.02));
    CHECK(test::meshVolume(mesh) == Approx(4 * kPi / 3 * radius * radius * radius).epsilon(0.025));
    float leastCosine = 1, farthest = 0;
    for (const SurfaceVertex& v : mesh.vertices) {
        const vec3 outward = v.position - centre;
        leastCosine = std::min(leastCosine, glm::dot(v.normal, glm::normalize(outward)));
        farthest = std::max(farthest, std::abs(glm::length(outward) - float(radius)));
        REQUIRE(glm::length(v.normal) == Approx(1.0f));
    }
    CHECK(leastCosine > 0.999f);
    CHECK(farthest < 0.02f * float(radius));
}

TEST_CASE("a ball cut by the box is capped flat, with the face's normal on the cap") {
    Surface surface(test::shaders(), {32, 8, 0.6f}, vec3(-1), vec3(1));
    updateWith(surface, {vec4(0.0f, -0.9f, 0.0f, 0.0f)});
    const test::Mesh mesh = test::readMesh(surface);
    const double radius = 0.4 * (std::sqrt(3.0) / 2 + 7 * std::sqrt(3.0)) * 2 / 32, height = radius + 0.1;
    constexpr double kPi = 3.14159265358979;
    CHECK(test::unmatchedSides(mesh).empty());
    CHECK(test::meshVolume(mesh) == Approx(kPi * height * height * (radius - height / 3)).epsilon(0.025));
    size_t capped = 0, wrong = 0;
    for (const SurfaceVertex& v : mesh.vertices) {
        if (v.position.y != -1.0f || std::hypot(v.position.x, v.position.z) > 0.25f) continue;
        ++capped;
        wrong += v.normal != vec3(0, -1, 0);
    }
    CHECK(capped > 40);
    CHECK(wrong == 0);
}

TEST_CASE("the order of the particles changes no bit of the mesh") {
    Surface surface(test::shaders(), {24, 2}, vec3(-1), vec3(1));
    Particles particles = scattered(5000, vec3(-0.8f), vec3(0.8f), 3);
    updateWith(surface, particles);
    const test::Mesh first = test::readMesh(surface);
    std::shuffle(particles.begin(), particles.end(), std::mt19937(5));
    updateWith(surface, particles);
    const test::Mesh second = test::readMesh(surface);
    REQUIRE(first.vertices.size() == second.vertices.size());
    CHECK(first.indices == second.indices);
    CHECK(std::memcmp(first.vertices.data(), second.vertices.data(), first.vertices.size() * sizeof(SurfaceVertex)) ==
          0);
}

TEST_CASE("the surface's temperature is the mean of the particles there, in their own unit") {
    Surface surface(test::shaders(), {24, 2}, vec3(-1), vec3(1));
    surface.setTemperatureRange(300.0f, 3300.0f);
    Particles particles = scattered(5000, vec3(-0.8f), vec3(0.8f), 3);
    for (vec4& p : particles)
        p.w = p.x < 0 ? 300.0f : 1811.0f;
    updateWith(surface, particles);
    for (const SurfaceVertex& v : test::readMesh(surface).vertices) {
        REQUIRE(v.temperature > 299.9f);
        REQUIRE(v.temperature < 1811.5f);
        if (v.position.x < -0.2f) REQUIRE(v.temperature == Approx(300.0f));
        if (v.position.x > 0.2f) REQUIRE(std::abs(v.temperature - 1811.0f) < 0.5f);
    }
}

TEST_CASE("a mesh too large for its buffers is cut, counted and flagged") {
    Surface surface(test::shaders(), {48, 1}, vec3(-1), vec3(1));
    updateWith(surface, randomPattern(surface.grid(), 50, 9));
    const SurfaceStatistics statistics = surface.statistics();
    const auto most = surface.grid().mostVertices();
    CHECK(statistics.overflow);
    CHECK(statistics.vertices > most);
    const test::Mesh mesh = test::readMesh(surface);
    const auto drawn = surface.mesh().drawCommand->read<SurfaceDraw>(1).front().count / 3;
    CHECK(drawn == std::min<size_t>(statistics.triangles, surface.grid().mostTriangles()));
    CHECK(*std::max_element(mesh.indices.begin(), mesh.indices.end()) < most);

    updateWith(surface, {vec4(0.0f)}); // a mesh that fits is complete again
    CHECK_FALSE(surface.statistics().overflow);
    CHECK(test::unmatchedSides(test::readMesh(surface)).empty());
}

TEST_CASE("without particles there is no surface, not even that of the update before") {
    Surface surface(test::shaders(), {12, 2}, vec3(-1), vec3(1));
    updateWith(surface, scattered(3000, vec3(-0.5f), vec3(0.5f), 1));
    CHECK(surface.statistics().triangles > 0);
    updateWith(surface, {});
    CHECK(surface.statistics().triangles == 0);
    CHECK(surface.mesh().drawCommand->read<SurfaceDraw>(1).front().count == 0);
}

TEST_CASE("the statistics arrive without waiting") {
    Surface surface(test::shaders(), {12, 2}, vec3(-1), vec3(1));
    CHECK_FALSE(surface.pollStatistics().has_value());
    updateWith(surface, scattered(3000, vec3(-0.5f), vec3(0.5f), 1));
    surface.requestStatistics();
    glFinish();
    const auto polled = surface.pollStatistics();
    REQUIRE(polled.has_value());
    CHECK(polled->triangles == surface.statistics().triangles);
    CHECK(polled->blocks > 0);
    CHECK_FALSE(surface.pollStatistics().has_value());
}

TEST_CASE("the grid follows the box, and bad ones are refused") {
    CHECK(SurfaceGrid(64, vec3(-1), vec3(1)).cells == ivec3(64));
    const SurfaceGrid plate(200, vec3(0), vec3(0.1f, 0.006f, 0.05f));
    CHECK(plate.cells == ivec3(200, 12, 100));
    CHECK(SurfaceGrid(10, vec3(0), vec3(1.0f, 0.01f, 1.0f)).cells.y == 2);
    CHECK_THROWS_AS(SurfaceGrid(1, vec3(-1), vec3(1)), InputError);
    CHECK_THROWS_AS(SurfaceGrid(5000, vec3(-1), vec3(1)), InputError);
    CHECK_THROWS_AS(SurfaceGrid(64, vec3(-1), vec3(1, -1, 1)), InputError);
    SurfaceParameters parameters;
    const ParameterList list = describe(parameters);
    setParameter(list, "influence", "3", "test");
    CHECK(parameters.influence == 3);
    CHECK_THROWS_AS(setParameter(list, "cells", "129", "test"), InputError);
    CHECK(findParameter(list, "cells")->onlyAtStart);
}

} // namespace meltpool
