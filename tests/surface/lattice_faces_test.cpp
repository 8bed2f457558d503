// Metal on its lattice: flat faces, sharp edges, and an unchanged mesh around metal that melted.
#include "core/metal/state/metal_state.hpp"
#include "core/surface/surface_level.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/surface/surface_twin.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

using glm::dvec3;
using glm::vec3;
using glm::vec4;

namespace {

constexpr float kSpacing = 1e-3f;
constexpr vec3 kPlateLow{-0.012f, -0.006f, -0.009f}, kPlateHigh{0.012f, 0, 0.009f};

/// The history that a plate's particles store: their freezing time or their peak temperature.
enum class Past { frozen, hottest };

/// A plate and its part that melted.
struct LatticePlate {
    LatticePlate() : lattice(MetalLattice::covering(kPlateLow, kPlateHigh, kSpacing)) {
        const auto seeds = latticeSeeds(lattice, kPlateLow, kPlateHigh, 300);
        std::vector<unsigned> cells(lattice.cellCount(), 0);
        for (const MetalSeed& seed : seeds) {
            places.emplace_back(seed.position, seed.temperature);
            cells[lattice.index(lattice.cellAt(seed.position))] = static_cast<unsigned>(places.size());
        }
        slots = std::move(cells);
        times.assign(places.size(), 0);
    }

    /// Takes the particles around a spot off the lattice, moves them and lets them freeze.
    void melt(vec3 spot, float radius) {
        for (size_t i = 0; i < places.size(); ++i) {
            const vec3 at = places[i];
            if (glm::distance(at, spot) > radius || times[i] != 0) continue;
            slots[lattice.index(lattice.cellAt(at))] = 0;
            places[i] += vec4(0.2f, 0.4f, -0.3f, 0) * kSpacing;
            times[i] = 3;
        }
    }

    void update(Surface& surface, bool withLattice, Past past) const {
        const gl::Buffer positions("plate", std::span<const vec4>(places));
        const gl::Buffer frozen("plate times", std::span<const float>(times));
        const gl::Buffer cells("plate cells", std::span<const unsigned>(slots));
        std::vector<vec4> heat;
        for (const float time : times)
            heat.emplace_back(0, 0, time > 0 ? 2000 : 300, 0);
        const gl::Buffer heats("plate heats", std::span<const vec4>(heat));
        ParticleView view{&positions, places.size()};
        (past == Past::frozen ? view.frozenAt : view.heats) = past == Past::frozen ? &frozen : &heats;
        view.solidus = past == Past::frozen ? 0 : 1768;
        if (withLattice) {
            view.lattice = &lattice;
            view.latticeSlots = &cells;
        }
        surface.update(view, nullptr);
        glFinish();
    }

    MetalLattice lattice;
    std::vector<vec4> places;
    std::vector<float> times;
    std::vector<unsigned> slots;
};

/// A surface as in lessons: cells of 0.86 spacings, in a box that fits neither lattice nor grid. `shift` is the grid's,
/// in spacings.
struct PlateSurface {
    explicit PlateSurface(float shift)
        : surface(test::shaders(), {40, 3, 1, true, int(SurfaceKernel::smooth)},
                  kPlateLow - vec3(0.0051f, 0.004f, 0.0047f) + shift * kSpacing,
                  kPlateHigh + vec3(0.0053f, 0.005f, 0.0043f) + shift * kSpacing) {
        surface.setTemperatureRange(293, 3500);
        surface.flatFaces.corners = {kPlateLow, kPlateHigh};
        surface.flatFaces.count = 2;
        surface.parameters.isoLevel *= flatFaceLevel(surface.parameters, surface.grid(), kSpacing);
    }
    Surface surface;
};

/// Returns the root mean square angle between the upper face's normals and the vertical away from its edges, degrees.
double faceTilt(const test::Mesh& mesh) {
    double square = 0, count = 0;
    for (const SurfaceVertex& v : mesh.vertices) {
        if (v.position.y < -0.5f * kSpacing || std::abs(v.position.x) > 0.008f || std::abs(v.position.z) > 0.005f)
            continue;
        const double tilt = std::acos(std::min(double(v.normal.y), 1.0)) * 57.29578;
        square += tilt * tilt;
        count += 1;
    }
    REQUIRE(count > 100);
    return std::sqrt(square / count);
}

/// Returns the distance from a point to a triangle, or slightly more.
double distanceTo(dvec3 p, dvec3 a, dvec3 b, dvec3 c) {
    double least = 1;
    constexpr int kParts = 12; // parts of a triangle's side: points on it are a twentieth of a spacing apart
    for (int i = 0; i <= kParts; ++i)
        for (int j = 0; i + j <= kParts; ++j) {
            const double u = double(i) / kParts, v = double(j) / kParts;
            least = std::min(least, glm::distance(p, a + u * (b - a) + v * (c - a)));
        }
    return least;
}

/// Returns the largest radius, in spacings, that rounds the plate's upper front edge: the distance from an edge to its
/// arc of radius r is r (sqrt(2) - 1).
double edgeRadius(const test::Mesh& mesh) {
    double radius = 0;
    for (double x = -0.0093; x < 0.0093; x += 0.00047) {
        const dvec3 p(x, 0, double(kPlateHigh.z));
        double least = 1;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const std::array<dvec3, 3> c{mesh.vertices[mesh.indices[i]].position,
                                         mesh.vertices[mesh.indices[i + 1]].position,
                                         mesh.vertices[mesh.indices[i + 2]].position};
            if (glm::distance(c[0], p) < 0.004) least = std::min(least, distanceTo(p, c[0], c[1], c[2]));
        }
        radius = std::max(radius, least / (std::sqrt(2.0) - 1) / double(kSpacing));
    }
    return radius;
}

/// Area of triangles that face along their vertices' normals, and of those that face the other way, m². Near an edge a
/// face may fold in its own plane, where a grid plane coincides with it.
struct FaceAreas {
    double seen = 0, turned = 0;
};

FaceAreas faceAreas(const test::Mesh& mesh) {
    FaceAreas areas;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const SurfaceVertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                            &c = mesh.vertices[mesh.indices[i + 2]];
        const dvec3 area =
            0.5 * glm::cross(dvec3(b.position) - dvec3(a.position), dvec3(c.position) - dvec3(a.position));
        const bool seen = glm::dot(area, dvec3(a.normal) + dvec3(b.normal) + dvec3(c.normal)) >= 0;
        (seen ? areas.seen : areas.turned) += glm::length(area);
    }
    return areas;
}

} // namespace

TEST_CASE("a flat plate on its lattice is flat, and its edges are sharp, wherever the grid lies") {
    const LatticePlate plate;
    const Past past = GENERATE(Past::frozen, Past::hottest);
    for (const float shift : {0.0f, 0.13f, 0.31f, 0.5f, 0.77f}) {
        PlateSurface rounded(shift), flat(shift);
        plate.update(rounded.surface, false, past);
        plate.update(flat.surface, true, past);
        const test::Mesh before = test::readMesh(rounded.surface), mesh = test::readMesh(flat.surface);
        const double tilt = faceTilt(mesh), radius = edgeRadius(mesh);
        INFO("shift " << shift << ": tilt " << tilt << " degrees, was " << faceTilt(before) << "; edge radius "
                      << radius << " spacings, was " << edgeRadius(before));
        CHECK(tilt <= 0.2);
        CHECK(radius <= 0.6);
        CHECK(test::unmatchedSides(mesh).empty());
        const dvec3 size(kPlateHigh - kPlateLow);
        const double exact = size.x * size.y * size.z;
        CHECK(test::meshVolume(mesh) == Approx(exact).epsilon(0.002));
        const FaceAreas areas = faceAreas(mesh);
        CHECK(areas.seen - areas.turned ==
              Approx(2 * (size.x * size.y + size.y * size.z + size.z * size.x)).epsilon(1e-4));
        CHECK(areas.turned < 0.03 * areas.seen);
        for (const SurfaceVertex& v : mesh.vertices) // every vertex is on the plate's surface
            REQUIRE(glm::all(glm::lessThan(glm::abs(v.position - 0.5f * (kPlateLow + kPlateHigh)),
                                           0.5f * (kPlateHigh - kPlateLow) + 1e-6f)));
    }
}

TEST_CASE("where metal melted its surface stays the volumes', and the flat metal beside it begins without a step") {
    LatticePlate plate;
    const Past past = GENERATE(Past::frozen, Past::hottest);
    plate.melt({0, 0, 0}, 3.2e-3f);
    PlateSurface rounded(0.2f), flat(0.2f);
    plate.update(rounded.surface, false, past);
    plate.update(flat.surface, true, past);
    const test::Mesh before = test::readMesh(rounded.surface), mesh = test::readMesh(flat.surface);
    REQUIRE(before.indices == mesh.indices);
    size_t same = 0, between = 0;
    for (size_t i = 0; i < mesh.vertices.size(); ++i) {
        const vec3 place = before.vertices[i].position;
        const float moved = glm::distance(mesh.vertices[i].position, place);
        if (glm::distance(place, vec3(0)) < 2.5e-3f) {
            REQUIRE(moved == 0);
            ++same;
        }
        if (moved > 0 && std::abs(place.x) < 0.008f && std::abs(place.z) < 0.005f && place.y > -0.002f) {
            CHECK(moved < 0.35f * kSpacing);
            ++between;
        }
    }
    CHECK(same > 20);
    CHECK(between > 20);
}

TEST_CASE("incremental updates of a plate that melts give the mesh that a fresh one gives") {
    LatticePlate plate;
    const Past past = GENERATE(Past::frozen, Past::hottest);
    PlateSurface updated(0.4f), fresh(0.4f);
    updated.surface.incremental.enabled = true;
    for (int step = 0; step < 6; ++step) {
        INFO("step " << step);
        if (step > 0) plate.melt({-0.008f + 0.003f * float(step), 0, 0.006f}, 2e-3f); // next to an edge
        plate.update(updated.surface, true, past);
        plate.update(fresh.surface, true, past);
        const auto sorted = [](const Surface& surface) {
            const test::Mesh mesh = test::readMesh(surface);
            std::vector<std::array<float, 6>> rows;
            for (const unsigned i : mesh.indices) {
                const SurfaceVertex& v = mesh.vertices[i];
                rows.push_back({v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z});
            }
            std::sort(rows.begin(), rows.end());
            return rows;
        };
        REQUIRE(sorted(updated.surface) == sorted(fresh.surface));
    }
}

} // namespace meltpool
