// Queries of the surface against a CPU twin that marches through the volumes in tiny steps, and against flat metal.
#include "core/surface/surface_level.hpp"
#include "core/surface/surface_probe.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <random>
#include <vector>

namespace meltpool {

using glm::dvec3;
using glm::ivec3;
using glm::vec3;
using glm::vec4;

namespace {

/// The density and heat of a surface between its corners, after a readback.
class Field {
  public:
    explicit Field(const Surface& surface)
        : grid_(surface.grid()),
          iso_(double(surface.parameters.isoLevel) * SURFACE_UNIT),
          density_(surface.densityVolume().read<std::uint32_t>(grid_.blockCount() * SURFACE_BLOCK_CORNERS)),
          heat_(surface.temperatureVolume().read<std::uint32_t>(grid_.blockCount() * SURFACE_BLOCK_CORNERS)) {}

    bool inside(dvec3 place) const { return at(place, density_) >= iso_; }
    double temperature(dvec3 place) const { return at(place, heat_) / at(place, density_); }

    /// Returns the distance at which the inside begins or ends, in steps of a fiftieth of a cell; `reach` if there is
    /// no change.
    double change(dvec3 from, dvec3 way, double reach) const {
        const double step = double(grid_.boxMax.x - grid_.boxMin.x) / double(grid_.cells.x) / 50;
        const bool start = inside(from);
        for (double t = 0; t < reach; t += step)
            if (inside(from + way * t) != start) return t - step / 2;
        return reach;
    }

  private:
    double at(dvec3 place, const std::vector<std::uint32_t>& volume) const {
        const SurfaceSetup s = grid_.setup();
        const dvec3 corner = (place - dvec3(s.origin)) * (dvec3(s.cells) / dvec3(s.extent)) + 1.0;
        if (glm::any(glm::lessThan(corner, dvec3(1))) || glm::any(glm::greaterThan(corner, dvec3(s.cells) + 1.0)))
            return 0;
        const ivec3 low = glm::min(ivec3(corner), grid_.cells);
        const dvec3 part = corner - dvec3(low);
        double sum = 0;
        for (int z = 0; z < 2; ++z)
            for (int y = 0; y < 2; ++y)
                for (int x = 0; x < 2; ++x)
                    sum += (x != 0 ? part.x : 1 - part.x) * (y != 0 ? part.y : 1 - part.y) *
                           (z != 0 ? part.z : 1 - part.z) * volume[grid_.address(low + ivec3(x, y, z))];
        return sum;
    }

    SurfaceGrid grid_;
    double iso_;
    std::vector<std::uint32_t> density_, heat_;
};

void update(Surface& surface, const std::vector<vec4>& particles) {
    const gl::Buffer buffer("particles", std::span<const vec4>(particles));
    surface.update({&buffer, particles.size()}, nullptr);
    glFinish();
}

/// Returns a ball of particles, hotter to the right.
std::vector<vec4> ball() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(-1, 1);
    std::vector<vec4> particles;
    while (particles.size() < 2000) {
        const vec3 place(uniform(random), uniform(random), uniform(random));
        if (glm::length(place) < 0.6f) particles.emplace_back(place, 0.5f + 0.5f * place.x);
    }
    return particles;
}

/// Returns particles of a cubic lattice that fill the lower part of the box up to `top`.
std::vector<vec4> slab(float spacing, float top) {
    std::vector<vec4> particles;
    for (float z = -1 + spacing / 2; z < 1; z += spacing)
        for (float y = top - spacing / 2; y > -1; y -= spacing)
            for (float x = -1 + spacing / 2; x < 1; x += spacing)
                particles.emplace_back(x, y, z, 0.25f);
    return particles;
}

vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return glm::normalize(vec3(normal(random), normal(random), normal(random)));
}

} // namespace

TEST_CASE("a query from anywhere finds what marching in tiny steps finds") {
    test::context();
    Surface surface(test::shaders(), {27, 2, 1.0f, true, 0}, vec3(-1), vec3(1, 1.1f, 0.9f));
    update(surface, ball());
    const Field field(surface);
    SurfaceProbe probe(test::shaders());
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-1.6f, 1.6f);
    const double cell = 2.0 / 27;
    int met = 0, insides = 0;
    for (int i = 0; i < 120; ++i) {
        const vec3 point = vec3(uniform(random), uniform(random), uniform(random)) * (i % 2 == 0 ? 1.0f : 0.35f);
        const vec3 axis = i % 3 == 0 ? randomDirection(random)
                                     : glm::normalize(randomDirection(random) * 0.4f - glm::normalize(point));
        const ProbeAim aim{point, axis, 2};
        const SurfaceProbeAnswer found = probe.now(surface, aim);
        const bool inside = field.inside(aim.point);
        const double ahead = field.change(aim.point, inside ? -aim.axis : aim.axis, 2);
        INFO("look " << i << " from " << aim.point.x << ' ' << aim.point.y << ' ' << aim.point.z);
        // At grazing incidence one search may hit the metal and the other miss it: then the twin finds metal close to
        // the ray.
        if (std::abs(std::abs(double(found.ahead)) - ahead) > 0.1 * cell) {
            const double other = field.change(dvec3(aim.point) + 0.05 * cell * dvec3(randomDirection(random)),
                                              inside ? -aim.axis : aim.axis, 2);
            CHECK(std::abs(std::abs(double(found.ahead)) - other) < 0.5 * cell);
        }
        CHECK((found.nearest < 0) == inside);
        insides += inside ? 1 : 0;
        // No metal in the rays' directions is much closer than the result.
        double nearest = 2;
        for (int j = 0; j < 60; ++j)
            nearest = std::min(nearest, field.change(aim.point, randomDirection(random), nearest));
        if (nearest < 0.3) CHECK(double(std::abs(found.nearest)) <= nearest * 1.2 + 0.1 * cell);
        CHECK(std::abs(found.nearest) <= std::abs(found.ahead) + 1e-5f);
        if (inside) CHECK(found.temperature == Approx(field.temperature(aim.point)).margin(1e-3));
        if (found.ahead >= 2 || inside) continue;
        ++met;
        const dvec3 place = dvec3(aim.point) + dvec3(aim.axis) * double(found.ahead);
        CHECK(found.temperature == Approx(field.temperature(place)).margin(5e-3));
    }
    CHECK(met > 10);
    CHECK(insides > 10);
}

TEST_CASE("over flat metal a query gives the height, the length along an inclined axis, and the normal") {
    test::context();
    const float spacing = 0.05f, top = 0.1f;
    Surface surface(test::shaders(), {46, 2, 1.0f, true, 0}, vec3(-1), vec3(1));
    surface.parameters.isoLevel = flatFaceLevel(surface.parameters, surface.grid(), spacing);
    update(surface, slab(spacing, top));
    SurfaceProbe probe(test::shaders());
    const float off = 0.25f * spacing; // the lattice's waves, and an iso level for the mean
    const float leaningOff = 0.35f * spacing * std::sqrt(2.0f);
    for (const float height : {0.5f, 0.11f, 0.02f, -0.03f, -0.3f}) {
        const SurfaceProbeAnswer straight = probe.now(surface, {{0.03f, top + height, -0.21f}, {0, -1, 0}, 2});
        INFO("height " << height);
        CHECK(straight.ahead == Approx(height).margin(off));
        CHECK(straight.nearest == Approx(height).epsilon(0.06).margin(off));
        CHECK(straight.temperature == Approx(0.25).margin(1e-3));
        if (height > 0) CHECK(straight.normal.y > 0.95f);
        const vec3 leaning = glm::normalize(vec3(1, -1, 0));
        if (height > -0.1f)
            CHECK(probe.now(surface, {{0.03f, top + height, -0.21f}, leaning, 2}).ahead ==
                  Approx(height * std::sqrt(2.0f)).margin(leaningOff));
    }
    const SurfaceProbeAnswer away = probe.now(surface, {{0, 0.5f, 0}, {0, 1, 0}, 0.3f});
    CHECK(away.ahead == 0.3f);
    CHECK(away.nearest == 0.3f);
}

TEST_CASE("an answer comes without waiting, the same bits each time; empty space has no metal") {
    test::context();
    Surface surface(test::shaders(), {21, 2, 1.0f, true, 0}, vec3(-1), vec3(1));
    SurfaceProbe probe(test::shaders());
    const ProbeAim aim{{0.2f, 0.9f, 0.1f}, {0, -1, 0}, 2};
    CHECK(probe.now(surface, aim).ahead == 2);
    update(surface, ball());
    const SurfaceProbeAnswer wanted = probe.now(surface, aim);
    CHECK(wanted.ahead < 1);
    probe.request(surface, aim);
    probe.request(surface, {{0, 0, 0}, {0, 1, 0}, 1}); // this request is dropped
    glFinish();
    std::optional<SurfaceProbeAnswer> answer;
    for (int i = 0; i < 100 && !answer; ++i)
        answer = probe.poll();
    REQUIRE(answer);
    CHECK(answer->ahead == wanted.ahead);
    CHECK(answer->nearest == wanted.nearest);
    CHECK(answer->temperature == wanted.temperature);
    CHECK_FALSE(probe.poll());
}

} // namespace meltpool
