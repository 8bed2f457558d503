// The level of a flat face: a block of metal has its own volume, independent of kernel reach and grid.
#include "core/surface/surface_level.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/surface/surface_twin.hpp"

#include <array>
#include <cmath>

namespace meltpool {

using glm::vec3;
using glm::vec4;

TEST_CASE("the mean weight is the kernel's integral") {
    const double pi = 3.14159265358979;
    const double square = 2.5 * 2.5;
    double sum = 0; // sum over shells
    for (double r = 0.0005; r < 2.5; r += 0.001)
        sum += 4 * pi * r * r * std::pow(1 - r * r / square, 3) * 0.001;
    CHECK(meanWeight(SurfaceKernel::smooth, 3) == Approx(sum).epsilon(1e-4));
    CHECK(meanWeight(SurfaceKernel::cone, 1) ==
          Approx(1 - 0.480296 / 0.866025).epsilon(0.01)); // mean distance in a cube
}

TEST_CASE("a block at the level of a flat face has its volume and faces") {
    // The block has 40 x 24 x 32 particles of spacing 1.
    std::vector<vec4> particles;
    for (int z = 0; z < 32; ++z)
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 40; ++x)
                particles.emplace_back(float(x) + 0.5f, float(y) + 0.5f, float(z) + 0.5f, 0.0f);
    test::context();
    const gl::Buffer buffer("block", std::span<const vec4>(particles));
    for (const auto& [kernel, influence, cells] :
         {std::array{0, 2, 48}, {0, 3, 48}, {1, 3, 48}, {1, 3, 96}, {1, 2, 40}, {1, 4, 64}}) {
        SurfaceParameters parameters{cells, influence, 1.0f, true, kernel};
        Surface surface(test::shaders(), parameters, vec3(-4, -4, -4), vec3(44, 28, 36));
        surface.parameters.isoLevel = flatFaceLevel(parameters, surface.grid(), 1.0f);
        surface.update({&buffer, particles.size()}, nullptr);
        const test::Mesh mesh = test::readMesh(surface);
        INFO("kernel " << kernel << ", influence " << influence << ", cells " << cells);
        CHECK(test::unmatchedSides(mesh).empty());
        CHECK(test::meshVolume(mesh) == Approx(40.0 * 24 * 32).epsilon(kernel == 0 ? 0.05 : 0.03));
        // Only the middle of the top face counts, between the rounded edges.
        for (const SurfaceVertex& v : mesh.vertices) {
            const bool middle = v.position.x > 8 && v.position.x < 32 && v.position.z > 8 && v.position.z < 24;
            if (middle && v.position.y > 12) REQUIRE(std::abs(v.position.y - 24) < 0.25f);
        }
    }
}

} // namespace meltpool
