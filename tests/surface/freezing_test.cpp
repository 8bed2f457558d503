// Freezing times at the surface: the volume against its twin, the mesh's times and gradients against closed forms.
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/surface/surface_twin.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace meltpool {

using glm::vec3;
using glm::vec4;

namespace {

constexpr vec3 kLow{-1.0f, -0.25f, -0.5f}, kHigh{1.0f, 0.25f, 0.5f};
constexpr float kSpacing = 0.05f;
constexpr float kTop = 0.0f; ///< height of the plate's top

/// A plate whose freezing times follow a law; 0 means that metal never melted.
struct FrozenPlate {
    explicit FrozenPlate(const std::function<float(vec3)>& law, float shake = 0) {
        std::mt19937 random(3);
        const auto next = [&random] { return float(random() >> 8) * 0x1p-24f - 0.5f; };
        for (float z = -0.475f; z < 0.5f; z += kSpacing)
            for (float y = -0.225f; y < kTop; y += kSpacing)
                for (float x = -0.975f; x < 1.0f; x += kSpacing) {
                    const vec3 place = vec3(x, y, z) + shake * kSpacing * vec3(next(), next(), next());
                    places.emplace_back(place, 300.0f);
                    times.push_back(law(place));
                }
    }

    void update(Surface& surface) const {
        const gl::Buffer positions("plate", std::span<const vec4>(places));
        const gl::Buffer frozen("plate times", std::span<const float>(times));
        surface.update({&positions, places.size(), nullptr, nullptr, &frozen}, nullptr);
        glFinish();
    }

    std::vector<vec4> places;
    std::vector<float> times;
};

/// A vertex of the plate's upper face, far from its edges.
struct FaceVertex {
    vec3 place;
    float share;
    SurfaceFreezing freezing;
};

std::vector<FaceVertex> upperFace(const Surface& surface) {
    const test::Mesh mesh = test::readMesh(surface);
    const auto freezing = surface.mesh().freezing->read<SurfaceFreezing>(mesh.vertices.size());
    std::vector<FaceVertex> face;
    for (size_t i = 0; i < mesh.vertices.size(); ++i) {
        const SurfaceVertex& v = mesh.vertices[i];
        if (v.position.y < kTop - kSpacing || std::abs(v.position.x) > 0.85f || std::abs(v.position.z) > 0.35f)
            continue;
        face.push_back({v.position, v.frozen, freezing[i]});
    }
    return face;
}

SurfaceParameters plateSurface(int influence = 3) {
    return {46, influence, influence > 2 ? 2.7f : 0.9f, true, int(SurfaceKernel::smooth)};
}

using Row = std::array<float, 8>;

/// Returns place, share, time and slope of all vertices of triangles, in an order independent of the mesh.
std::vector<Row> sortedFreezing(const Surface& surface) {
    const test::Mesh mesh = test::readMesh(surface);
    const auto freezing = surface.mesh().freezing->read<SurfaceFreezing>(mesh.vertices.size());
    std::vector<Row> rows;
    for (const unsigned i : mesh.indices) {
        const SurfaceVertex& v = mesh.vertices[i];
        const SurfaceFreezing& f = freezing[i];
        rows.push_back({v.position.x, v.position.y, v.position.z, v.frozen, f.time, f.slope.x, f.slope.y, f.slope.z});
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

} // namespace

TEST_CASE("the freezing volume is its twin's, and incremental updates give what a fresh one gives") {
    for (const int kernel : {int(SurfaceKernel::cone), int(SurfaceKernel::smooth)})
        for (const int influence : {2, 4}) {
            SurfaceParameters parameters = plateSurface(influence);
            parameters.kernel = kernel;
            Surface updated(test::shaders(), parameters, kLow, kHigh), fresh(test::shaders(), parameters, kLow, kHigh);
            updated.incremental.enabled = true;
            FrozenPlate plate([](vec3 p) { return p.x < -0.5f ? 700.0f + p.z : p.x > 0.8f ? 2100.0f : 0.0f; }, 0.3f);
            for (int step = 0; step < 5; ++step) {
                INFO("kernel " << kernel << ", influence " << influence << ", step " << step);
                plate.update(updated);
                plate.update(fresh);
                const auto twin = test::twinFreezing(updated.grid(), parameters, plate.places, plate.times);
                REQUIRE(updated.freezingVolume()->read<glm::uvec2>(twin.size()) == twin);
                REQUIRE(sortedFreezing(updated) == sortedFreezing(fresh));
                if (step > 0) CHECK(updated.statistics().particles < plate.places.size() / 8);
                // As the torch travels, metal behind it freezes and other metal melts again.
                const float front = -0.5f + 0.1f * float(step);
                for (size_t i = 0; i < plate.places.size(); ++i) {
                    const float x = plate.places[i].x;
                    if (x > front && x < front + 0.1f) plate.times[i] = 701.0f + x;
                    if (x < -0.9f && plate.places[i].z > 0.2f) plate.times[i] = -1;
                }
            }
        }
}

TEST_CASE("time and gradient at the surface are those of the law by which the metal froze") {
    // Freezing travels along the seam at 0.1 a second, later towards the middle, as behind a pool.
    const auto time = [](vec3 p) { return 20 + 10 * p.x - 8 * p.z * p.z; };
    const auto slope = [](vec3 p) { return vec3(10, 0, -16 * p.z); };
    for (const float shake : {0.0f, 0.3f}) {
        Surface surface(test::shaders(), plateSurface(), kLow, kHigh);
        FrozenPlate(time, shake).update(surface);
        double square = 0, farthest = 0, latest = 0;
        const auto face = upperFace(surface);
        REQUIRE(face.size() > 300);
        for (const FaceVertex& v : face) {
            vec3 off = v.freezing.slope - slope(v.place);
            off.y = 0; // the picture ignores the component across the surface
            square += double(glm::dot(off, off));
            farthest = std::max(farthest, double(glm::length(off)));
            latest = std::max(latest, double(std::abs(v.freezing.time - time(v.place))));
            CHECK(v.share > 0.95f);
        }
        INFO("shaken by " << shake << " spacings: slope off by " << std::sqrt(square / double(face.size()))
                          << " on the mean, " << farthest << " at most; time by " << latest);
        CHECK(std::sqrt(square / double(face.size())) < (shake > 0 ? 0.4 : 0.1)); // the slope is 10
        CHECK(farthest < (shake > 0 ? 1.2 : 0.3));
        CHECK(latest < (shake > 0 ? 0.12 : 0.06)); // 0.5 is one spacing
    }
}

TEST_CASE("metal that never froze takes nothing from the time of its neighbours") {
    const auto time = [](vec3 p) { return 50 + 10 * p.x; };
    Surface surface(test::shaders(), plateSurface(), kLow, kHigh);
    FrozenPlate([&](vec3 p) { return std::abs(p.z) < 0.2f ? time(p) : 0.0f; }).update(surface);
    size_t bare = 0, border = 0;
    for (const FaceVertex& v : upperFace(surface)) {
        const float beyond = std::abs(v.place.z) - 0.2f;
        if (beyond > 0.12f) {
            ++bare;
            REQUIRE(v.share == 0);
            REQUIRE(v.freezing.time == 0);
            REQUIRE(v.freezing.slope == vec3(0));
        } else if (v.share > 0) {
            border += v.share < 0.9f;
            CHECK(double(std::abs(v.freezing.time - time(v.place))) < 0.3);
            CHECK(double(v.freezing.slope.x) == Approx(10).margin(1));
            CHECK(double(std::abs(v.freezing.slope.z)) < 0.5); // frozen metal and metal without a time differ by 50 s
        }
        if (beyond < -0.12f) CHECK(v.share > 0.95f);
    }
    CHECK(bare > 50);
    CHECK(border > 50);
}

TEST_CASE("a surface of particles without freezing times has none, and says so") {
    Surface surface(test::shaders(), plateSurface(), kLow, kHigh);
    const FrozenPlate plate([](vec3) { return 1.0f; });
    plate.update(surface);
    CHECK(surface.mesh().freezing != nullptr);
    const size_t with = surface.bytes();
    const gl::Buffer positions("plate", std::span<const vec4>(plate.places));
    surface.update({&positions, plate.places.size()}, nullptr);
    CHECK(surface.mesh().freezing == nullptr);
    CHECK(surface.freezingVolume() == nullptr);
    for (const SurfaceVertex& v : test::readMesh(surface).vertices)
        REQUIRE(v.frozen == 0);
    Surface plain(test::shaders(), plateSurface(), kLow, kHigh);
    plain.update({&positions, plate.places.size()}, nullptr);
    CHECK(plain.bytes() < with);
}

} // namespace meltpool
