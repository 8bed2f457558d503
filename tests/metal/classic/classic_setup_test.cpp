// The classic model's parts that need no GPU: kernels against their integrals, start arrangements, descriptions of
// parameters, and the grid's size.
#include "core/base/error.hpp"
#include "core/metal/classic/arrangement.hpp"
#include "core/metal/classic/cell_order.hpp"
#include "core/metal/classic/classic_kernels.hpp"
#include "tests/support/catch.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <functional>
#include <set>

namespace meltpool {

namespace {

constexpr double kPi = std::numbers::pi;

/// Returns the integral of f between the bounds by Simpson's rule.
double integrate(double from, double to, const std::function<double(double)>& f) {
    const int pieces = 4000;
    const double width = (to - from) / pieces;
    double sum = f(from) + f(to);
    for (int i = 1; i < pieces; ++i)
        sum += f(from + i * width) * (i % 2 == 1 ? 4 : 2);
    return sum * width / 3;
}

double overSphere(double h, const std::function<double(double)>& f) {
    return integrate(0, h, [&f](double r) { return 4 * kPi * r * r * f(r); });
}

} // namespace

TEST_CASE("the classic kernels integrate to one") {
    for (const double h : {0.02, 0.05, 0.3, 1.0}) {
        const ClassicKernels kernels(h);
        CHECK(overSphere(h, [&](double r) { return kernels.poly6(r); }) == Approx(1).epsilon(1e-9));
        // Integration by parts: the integral of W over the sphere is that of -slope 4/3 pi r³ over r.
        CHECK(integrate(0, h, [&](double r) { return -kernels.spikySlope(r) * 4 / 3 * kPi * r * r * r; }) ==
              Approx(1).epsilon(1e-9));
        // Gauss's theorem: the Laplacian inside radius r gives the slope at r, and the slope gives the kernel.
        const auto slope = [&](double r) {
            return overSphere(r, [&](double s) { return kernels.viscosityLaplacian(s); }) / (4 * kPi * r * r) -
                   15.0 / (4 * kPi * h * h * r * r); // the kernel's term h/(2r) is harmonic for r > 0
        };
        const double total = integrate(1e-6 * h, h, [&](double r) { return -slope(r) * 4 / 3 * kPi * r * r * r; });
        CHECK(total == Approx(1).epsilon(1e-4));
        for (const double r : {h * 1.0001, 2 * h}) {
            CHECK(kernels.poly6(r) == 0);
            CHECK(kernels.spikySlope(r) == 0);
            CHECK(kernels.viscosityLaplacian(r) == 0);
        }
    }
}

TEST_CASE("the classic kernels' gradients sum to zero around a place of symmetry") {
    const double h = 0.05, spacing = 0.02;
    const ClassicKernels kernels(h);
    glm::dvec3 spiky(0), poly6(0);
    double size = 0;
    for (int z = -3; z <= 3; ++z)
        for (int y = -3; y <= 3; ++y)
            for (int x = -3; x <= 3; ++x) {
                const glm::dvec3 apart = spacing * glm::dvec3(x, y, z);
                const double r = std::sqrt(apart.x * apart.x + apart.y * apart.y + apart.z * apart.z);
                if (r == 0 || r > h) continue;
                spiky += kernels.spikySlope(r) / r * apart;
                const double slope = (kernels.poly6(r * 1.00001) - kernels.poly6(r * 0.99999)) / (0.00002 * r);
                poly6 += slope / r * apart;
                size += std::abs(kernels.spikySlope(r));
            }
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(std::abs(spiky[axis]) < 1e-12 * size);
        CHECK(std::abs(poly6[axis]) < 1e-12 * size);
    }
}

TEST_CASE("an ordered start is a lattice with the rest inside it") {
    for (const int count : {1, 7, 8, 63, 65, 1234, 8000, 8191, 20032}) {
        const auto places = arrangeParticles({count, ClassicSetup::kOrdered, 1});
        REQUIRE(places.size() == size_t(count));
        int edge = 1;
        while ((edge + 1) * (edge + 1) * (edge + 1) <= count)
            ++edge;
        std::set<float> levels;
        const size_t lattice = size_t(edge * edge * edge);
        for (size_t i = 0; i < places.size(); ++i) {
            const float limit = i < lattice ? 0.5F : 0.25F;
            const float most = std::max({std::abs(places[i].x), std::abs(places[i].y), std::abs(places[i].z)});
            if (most > limit || places[i].w != 0) FAIL("particle " << i << " of " << count << " is out of place");
            if (i < lattice) levels.insert({places[i].x, places[i].y, places[i].z});
        }
        CHECK(levels.size() == size_t(edge));
    }
}

TEST_CASE("a random start fills the cube, the same for the same seed") {
    const auto places = arrangeParticles({20032, ClassicSetup::kRandom, 7});
    CHECK(places == arrangeParticles({20032, ClassicSetup::kRandom, 7}));
    CHECK(places != arrangeParticles({20032, ClassicSetup::kRandom, 8}));
    glm::dvec3 mean(0), squares(0);
    for (const glm::vec4& p : places) {
        const glm::dvec3 place(p);
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 0.5F) FAIL("outside the cube");
        mean += place / 20032.0;
        squares += place * place / 20032.0;
    }
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(std::abs(mean[axis]) < 0.01);
        CHECK(squares[axis] == Approx(1.0 / 12).epsilon(0.03));
    }
}

TEST_CASE("a metal without particles is refused") {
    CHECK_THROWS_AS(arrangeParticles({0, ClassicSetup::kOrdered, 1}), InputError);
    CHECK_THROWS_AS(arrangeParticles({-5, ClassicSetup::kRandom, 1}), InputError);
}

TEST_CASE("every classic parameter's default is in its range and reads back") {
    ClassicParameters parameters;
    ClassicSetup setup;
    for (const ParameterList& list : {describe(parameters), describe(setup)}) {
        std::set<std::string_view> keys;
        for (const Parameter& p : list) {
            CHECK(keys.insert(p.key).second);
            CHECK_FALSE(p.note.empty());
            CHECK_NOTHROW(setParameter(list, p.key, parameterText(p), "test"));
        }
    }
    CHECK(parameters.timeStep == 1.0F / 60.0F);
}

TEST_CASE("the grid covers the box with cells no smaller than the support radius") {
    for (const float h : {0.01F, 0.0137F, 0.05F, 0.3F, 1.0F})
        for (const size_t count : {size_t(1), size_t(65), size_t(8192), size_t(1048576)}) {
            const CellGrid grid = CellGrid::forRadius(h, count);
            CHECK(grid.perAxis >= 1);
            CHECK(grid.cells() <= 8 * count);
            CHECK(1.0F / grid.cellsPerUnit > h);
            CHECK(float(grid.perAxis) / grid.cellsPerUnit > 1.9999F);
        }
    CHECK(CellGrid::forRadius(0.05F, 20032).perAxis == 40);
}

} // namespace meltpool
