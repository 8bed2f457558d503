// Metal on its lattice in a pipe: round faces without the steps of its cells, flat ends.
#include "core/metal/state/metal_state.hpp"
#include "core/surface/surface_level.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/surface/surface_twin.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

using glm::vec2;
using glm::vec3;
using glm::vec4;

namespace {

constexpr float kSpacing = 1e-3F, kOuter = 0.015F, kInner = 0.011F, kHalfLength = 0.01F;
constexpr vec3 kLow{-kOuter, -kOuter, -kHalfLength}, kHigh{kOuter, kOuter, kHalfLength};

/// Cells whose middles are in the pipe, as in a workpiece.
struct LatticePipe {
    LatticePipe() : lattice(MetalLattice::covering(kLow, kHigh, kSpacing)), slots(lattice.cellCount(), 0) {
        for (const MetalSeed& seed : latticeSeeds(lattice, kLow, kHigh, 300)) {
            const float radius = glm::length(vec2(seed.position));
            if (radius > kOuter || radius < kInner) continue;
            places.emplace_back(seed.position, seed.temperature);
            slots[lattice.index(lattice.cellAt(seed.position))] = static_cast<unsigned>(places.size());
        }
        heats.assign(places.size(), vec4(0, 0, 300, 0));
    }

    /// Heats the metal around the spot, so that it counts as melted.
    void melt(vec3 spot, float radius) {
        for (size_t i = 0; i < places.size(); ++i)
            if (glm::distance(vec3(places[i]), spot) < radius) heats[i].z = 2000;
    }

    test::Mesh mesh(bool round) const {
        Surface surface(test::shaders(), {40, 3, 1, true, int(SurfaceKernel::smooth)},
                        kLow - vec3(0.0051F, 0.004F, 0.0047F), kHigh + vec3(0.0053F, 0.005F, 0.0043F));
        surface.setTemperatureRange(293, 3500);
        surface.parameters.isoLevel *= flatFaceLevel(surface.parameters, surface.grid(), kSpacing);
        if (round) surface.roundFaces = {vec2(0), -kHalfLength, kHalfLength, kOuter, kInner};
        const gl::Buffer positions("pipe", std::span<const vec4>(places));
        const gl::Buffer cells("pipe cells", std::span<const unsigned>(slots));
        const gl::Buffer heat("pipe heats", std::span<const vec4>(heats));
        ParticleView view{&positions, places.size()};
        view.heats = &heat;
        view.solidus = 1768;
        view.lattice = &lattice;
        view.latticeSlots = &cells;
        surface.update(view, nullptr);
        glFinish();
        return test::readMesh(surface);
    }

    MetalLattice lattice;
    std::vector<vec4> places, heats;
    std::vector<unsigned> slots;
};

/// Measures of the outer face away from the ends: greatest distance from the circle, in spacings, and the root mean
/// square angle between normal and radius, degrees.
struct Roundness {
    double off = 0, tilt = 0;
};

Roundness roundnessOf(const test::Mesh& mesh) {
    Roundness found;
    double square = 0, count = 0;
    for (const SurfaceVertex& v : mesh.vertices) {
        const vec2 off(v.position);
        const float radius = glm::length(off);
        if (std::abs(v.position.z) > kHalfLength - 2 * kSpacing || radius < (kOuter + kInner) / 2) continue;
        found.off = std::max(found.off, double(std::abs(radius - kOuter) / kSpacing));
        const double tilt = std::acos(std::min(double(glm::dot(vec2(v.normal), off / radius)), 1.0)) * 57.29578;
        square += tilt * tilt;
        count += 1;
    }
    REQUIRE(count > 500);
    found.tilt = std::sqrt(square / count);
    return found;
}

} // namespace

TEST_CASE("a pipe on its lattice is round, and its ends are flat") {
    const LatticePipe pipe;
    const test::Mesh steps = pipe.mesh(false), mesh = pipe.mesh(true);
    const Roundness before = roundnessOf(steps), now = roundnessOf(mesh);
    INFO("off the circle by " << now.off << " spacings, was " << before.off << "; tilt " << now.tilt << " degrees, was "
                              << before.tilt);
    CHECK(before.tilt > 2);
    CHECK(now.off < 1e-3);
    CHECK(now.tilt < 0.2);
    CHECK(test::unmatchedSides(mesh).empty());
    const double exact = std::numbers::pi * double(kOuter * kOuter - kInner * kInner) * 2 * double(kHalfLength);
    CHECK(test::meshVolume(mesh) == Approx(exact).epsilon(0.01));
    for (const SurfaceVertex& v : mesh.vertices) {
        const float radius = glm::length(vec2(v.position));
        REQUIRE(radius < kOuter + 1e-6F);
        REQUIRE(radius > kInner - 1e-6F);
        REQUIRE(std::abs(v.position.z) < kHalfLength + 1e-6F);
        if (std::abs(v.normal.z) > 0.9F) CHECK(std::abs(v.position.z) == Approx(kHalfLength).margin(1e-6));
    }
}

TEST_CASE("where a pipe melted its surface stays the volumes'") {
    LatticePipe pipe;
    const vec3 spot(0, kOuter, 0);
    pipe.melt(spot, 4e-3F);
    const test::Mesh before = pipe.mesh(false), mesh = pipe.mesh(true);
    REQUIRE(before.indices == mesh.indices);
    size_t same = 0, moved = 0;
    for (size_t i = 0; i < mesh.vertices.size(); ++i) {
        const vec3 place = before.vertices[i].position;
        const bool stays = mesh.vertices[i].position == place;
        if (glm::distance(place, spot) < 2.5e-3F) {
            REQUIRE(stays);
            ++same;
        }
        moved += stays ? 0 : 1;
    }
    CHECK(same > 10);
    CHECK(moved > 1000);
}

} // namespace meltpool
