// Incremental updates of the surface: equal bits as from a new surface of these particles.
#include "shaders/shared/metal.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/surface/surface_twin.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

namespace meltpool {

using glm::vec3;
using glm::vec4;

namespace {

/// A plate with a few particles that move, warm, appear and vanish.
class Plate {
  public:
    static constexpr vec3 kLow{-1.0f, -0.25f, -0.5f}, kHigh{1.0f, 0.4f, 0.5f};

    Plate() {
        for (float z = -0.475f; z < 0.5f; z += 0.05f)
            for (float y = -0.225f; y < 0.0f; y += 0.05f)
                for (float x = -0.975f; x < 1.0f; x += 0.05f)
                    places.emplace_back(x, y, z, 0.1f);
        phases.assign(places.size(), PHASE_ALIVE);
    }

    /// Moves and warms the particles around a spot of the plate.
    void stir(vec3 spot, float radius) {
        for (size_t i = 0; i < places.size(); ++i) {
            if (glm::distance(vec3(places[i]), spot) > radius) continue;
            places[i] += vec4(next() - 0.5f, next() - 0.4f, next() - 0.5f, next()) * 0.05f;
            if (next() < 0.05f) phases[i] ^= PHASE_ALIVE;
        }
    }

    void add(vec3 place) {
        places.emplace_back(place, 0.9f);
        phases.push_back(PHASE_ALIVE);
    }

    /// Updates the surface; `numbers` are those of the particles if their order changes.
    void update(Surface& surface, const std::vector<unsigned>& numbers = {}) const {
        const gl::Buffer positions("plate", std::span<const vec4>(places));
        const gl::Buffer phaseBits("plate phases", std::span<const unsigned>(phases));
        ParticleView view{&positions, places.size(), &phaseBits};
        const gl::Buffer numberBits("plate numbers", std::span<const unsigned>(numbers.empty() ? phases : numbers));
        if (!numbers.empty()) view.numbers = &numberBits;
        surface.update(view, nullptr);
        glFinish();
    }

    std::vector<vec4> alive() const {
        std::vector<vec4> those;
        for (size_t i = 0; i < places.size(); ++i)
            if ((phases[i] & PHASE_ALIVE) != 0) those.push_back(places[i]);
        return those;
    }

    std::vector<vec4> places;
    std::vector<unsigned> phases;

  private:
    float next() { return float(random_() >> 8) * 0x1p-24f; }
    std::mt19937 random_{11};
};

/// Returns every triangle with position, temperature and normal of its corners, in an order independent of the mesh.
std::vector<std::array<float, 21>> sortedTriangles(const test::Mesh& mesh) {
    std::vector<std::array<float, 21>> rows;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<std::array<float, 7>, 3> corners{};
        for (size_t j = 0; j < 3; ++j)
            std::memcpy(corners[j].data(), &mesh.vertices[mesh.indices[i + j]], sizeof(corners[j]));
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        std::memcpy(rows.emplace_back().data(), corners.data(), sizeof(corners));
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

} // namespace

TEST_CASE("incremental updates give the surface that a fresh one gives") {
    for (const int kernel : {int(SurfaceKernel::cone), int(SurfaceKernel::smooth)})
        for (const bool caps : {true, false}) {
            const SurfaceParameters parameters{100, 3, 0.6f, caps, kernel};
            Surface updated(test::shaders(), parameters, Plate::kLow, Plate::kHigh);
            Surface fresh(test::shaders(), parameters, Plate::kLow, Plate::kHigh);
            updated.incremental.enabled = true;
            Plate plate;
            int incremental = 0;
            for (int step = 0; step < 9; ++step) {
                const vec3 spot(-0.6f + 0.05f * float(step), 0.0f, 0.05f);
                if (step > 0) plate.stir(spot, 0.12f);
                if (step > 4) plate.add(spot + vec3(0.0f, 0.1f, 0.0f));
                plate.update(updated);
                plate.update(fresh);
                INFO("step " << step << ", kernel " << kernel << ", caps " << caps);
                const test::Volumes twin = test::twinVolumes(updated.grid(), parameters, 0, 1, plate.alive());
                REQUIRE(updated.densityVolume().read<std::uint32_t>(twin.density.size()) == twin.density);
                REQUIRE(updated.temperatureVolume().read<std::uint32_t>(twin.density.size()) == twin.temperature);
                const test::Mesh ours = test::readMesh(updated), theirs = test::readMesh(fresh);
                REQUIRE(sortedTriangles(ours) == sortedTriangles(theirs));
                if (caps) REQUIRE(test::unmatchedSides(ours).empty());
                const SurfaceStatistics statistics = updated.statistics();
                REQUIRE_FALSE(statistics.overflow);
                incremental += !statistics.rebuilt;
                if (!statistics.rebuilt) {
                    CHECK(statistics.particles < plate.places.size() / 10);
                    CHECK(statistics.blocks < fresh.statistics().blocks);
                }
            }
            CHECK(incremental >= 1);
        }
}

TEST_CASE("particles whose order changes are known again by their numbers") {
    for (const int kernel : {int(SurfaceKernel::cone), int(SurfaceKernel::smooth)}) {
        const SurfaceParameters parameters{100, 3, 0.6f, true, kernel};
        Surface updated(test::shaders(), parameters, Plate::kLow, Plate::kHigh);
        Surface fresh(test::shaders(), parameters, Plate::kLow, Plate::kHigh);
        updated.incremental.enabled = true;
        Plate plate;
        std::vector<unsigned> numbers(plate.places.size());
        std::iota(numbers.begin(), numbers.end(), 0U);
        std::mt19937 random(5);
        for (int step = 0; step < 5; ++step) {
            if (step > 0) plate.stir(vec3(-0.6f + 0.05f * float(step), 0.0f, 0.05f), 0.12f);
            std::shuffle(numbers.begin(), numbers.end(), random);
            Plate shuffled = plate;
            for (size_t i = 0; i < numbers.size(); ++i) {
                shuffled.places[i] = plate.places[numbers[i]];
                shuffled.phases[i] = plate.phases[numbers[i]];
            }
            shuffled.update(updated, numbers);
            plate.update(fresh);
            INFO("step " << step << ", kernel " << kernel);
            const test::Volumes twin = test::twinVolumes(updated.grid(), parameters, 0, 1, plate.alive());
            REQUIRE((updated.densityVolume().read<std::uint32_t>(twin.density.size()) == twin.density));
            REQUIRE((updated.temperatureVolume().read<std::uint32_t>(twin.density.size()) == twin.temperature));
            REQUIRE((sortedTriangles(test::readMesh(updated)) == sortedTriangles(test::readMesh(fresh))));
            if (step > 0) CHECK(updated.statistics().particles < plate.places.size() / 10);
        }
        CHECK_FALSE(updated.statistics().rebuilt);
    }
}

TEST_CASE("a particle that leaps or only warms is taken from where it was, from nowhere outside the box") {
    for (const int kernel : {int(SurfaceKernel::cone), int(SurfaceKernel::smooth)}) {
        const SurfaceParameters parameters{100, 3, 0.6f, true, kernel};
        Surface surface(test::shaders(), parameters, Plate::kLow, Plate::kHigh);
        surface.incremental.enabled = true;
        Plate plate;
        const vec3 home = plate.places[7], cell(0.02f);
        for (const vec4 place :
             {vec4(home, 0.5f), vec4(home, 0.9f), vec4(Plate::kHigh - 2.5f * cell, 0.9f),
              vec4(Plate::kHigh - cell, 0.2f), vec4(Plate::kHigh + 3.0f, 0.2f), vec4(Plate::kLow - 1.5f * cell, 0.2f),
              vec4(home + cell, 0.2f), vec4(1e9f), vec4(NAN), vec4(home, 0.1f)}) {
            plate.places[7] = place;
            plate.update(surface);
            INFO("at " << place.x << ", kernel " << kernel);
            std::vector<vec4> there = plate.alive();
            if (std::isnan(place.x)) there.erase(there.begin() + 7);
            const test::Volumes twin = test::twinVolumes(surface.grid(), parameters, 0, 1, there);
            // Brackets prevent a print of the volumes, which are too long.
            CHECK((surface.densityVolume().read<std::uint32_t>(twin.density.size()) == twin.density));
            CHECK((surface.temperatureVolume().read<std::uint32_t>(twin.density.size()) == twin.temperature));
        }
    }
}

TEST_CASE("an update without changes makes no mesh") {
    Surface surface(test::shaders(), {64, 2}, Plate::kLow, Plate::kHigh);
    surface.incremental.enabled = true;
    Plate plate;
    plate.update(surface);
    CHECK(surface.statistics().rebuilt);
    CHECK(surface.statistics().particles == plate.places.size());
    const auto before = sortedTriangles(test::readMesh(surface));
    plate.update(surface);
    CHECK_FALSE(surface.statistics().rebuilt);
    CHECK(surface.statistics().particles == 0);
    CHECK(surface.statistics().blocks == 0);
    CHECK(sortedTriangles(test::readMesh(surface)) == before);
}

TEST_CASE("the mesh has the highest temperature that the metal had") {
    const SurfaceParameters parameters{64, 3, 0.6f, true, int(SurfaceKernel::smooth)};
    Surface updated(test::shaders(), parameters, Plate::kLow, Plate::kHigh);
    Surface fresh(test::shaders(), parameters, Plate::kLow, Plate::kHigh);
    updated.incremental.enabled = true;
    for (Surface* surface : {&updated, &fresh})
        surface->setTemperatureRange(300, 2300);
    Plate plate;
    std::vector<vec4> heats(plate.places.size(), vec4(0, 0, 300, 0));
    for (vec4& p : plate.places)
        p.w = 300;
    for (int step = 0; step < 5; ++step) { // a hot spot moves, the metal behind it cools
        for (size_t i = 0; i < plate.places.size(); ++i) {
            const bool hot = glm::distance(vec3(plate.places[i]), vec3(-0.4f + 0.1f * float(step), 0, 0)) < 0.12f;
            plate.places[i].w = hot ? 1500.0f : 300.0f;
            heats[i].z = std::max(heats[i].z, plate.places[i].w);
        }
        const gl::Buffer positions("plate", std::span<const vec4>(plate.places));
        const gl::Buffer heatBuffer("plate heats", std::span<const vec4>(heats));
        for (Surface* surface : {&updated, &fresh})
            surface->update({&positions, plate.places.size(), nullptr, &heatBuffer}, nullptr);
    }
    const auto sortedPeaks = [](const Surface& surface) {
        const test::Mesh mesh = test::readMesh(surface);
        const auto peaks = surface.mesh().peaks->read<float>(mesh.vertices.size());
        std::vector<std::array<float, 4>> rows;
        for (const unsigned i : mesh.indices)
            rows.push_back(
                {mesh.vertices[i].position.x, mesh.vertices[i].position.y, mesh.vertices[i].position.z, peaks[i]});
        std::sort(rows.begin(), rows.end());
        return rows;
    };
    const auto rows = sortedPeaks(updated);
    CHECK(rows == sortedPeaks(fresh));
    size_t tinted = 0;
    for (const auto& [x, y, z, peak] : rows) {
        if (y < -0.05f) continue;
        if (std::abs(x + 0.4f) < 0.02f && std::abs(z) < 0.02f) {
            CHECK(std::abs(peak - 1500) < 2); // cold now after former heat
            ++tinted;
        }
        if (x > 0.4f) REQUIRE(std::abs(peak - 300) < 1);
    }
    CHECK(tinted > 0);

    plate.update(fresh); // these particles have no peak temperatures
    CHECK(fresh.mesh().peaks == nullptr);
}

TEST_CASE("a small change updates a small part of the mesh, however often it happens") {
    Surface surface(test::shaders(), {128, 3, 0.6f}, Plate::kLow, Plate::kHigh);
    surface.incremental.enabled = true;
    Plate plate;
    plate.update(surface);
    const unsigned all = surface.statistics().blocks;
    for (int step = 0; step < 20; ++step) {
        plate.places[2000].y += 0.01f;
        plate.places[2000].w += 0.01f;
        plate.update(surface);
        REQUIRE_FALSE(surface.statistics().rebuilt);
        REQUIRE(surface.statistics().particles == 1);
        REQUIRE(surface.statistics().blocks * 3 <= all);
        REQUIRE(surface.statistics().blocks <= 64);
    }
    CHECK(test::unmatchedSides(test::readMesh(surface)).empty());
}

TEST_CASE("a change is splatted once it exceeds the tolerance") {
    Surface surface(test::shaders(), {64, 2}, Plate::kLow, Plate::kHigh);
    surface.incremental = {true, 0.1f, 0.01f};
    Plate plate;
    plate.update(surface);
    const float cell = 2.0f / 64;
    unsigned splatted = 0;
    for (int step = 0; step < 10; ++step) {
        plate.places[100].x += 0.03f * cell;
        plate.places[2000].w += 0.003f;
        plate.update(surface);
        splatted += surface.statistics().particles;
    }
    CHECK(splatted == 4); // one each after every fourth step: 0.12 cells, 0.012 of the range
}

TEST_CASE("another iso level, influence or temperature range takes effect in the next incremental update") {
    Surface updated(test::shaders(), {48, 2, 1.0f}, Plate::kLow, Plate::kHigh);
    updated.incremental.enabled = true;
    Plate plate;
    plate.update(updated);
    const auto check = [&] {
        Surface fresh(test::shaders(), updated.parameters, Plate::kLow, Plate::kHigh);
        fresh.setTemperatureRange(-2, 2);
        plate.update(updated);
        plate.update(fresh);
        REQUIRE(sortedTriangles(test::readMesh(updated)) == sortedTriangles(test::readMesh(fresh)));
    };
    updated.setTemperatureRange(-2, 2);
    check();
    updated.parameters.isoLevel = 2.0f;
    check();
    updated.parameters.influence = 3;
    check();
    updated.parameters.caps = false;
    check();
    plate.places.resize(1000);
    plate.phases.resize(1000);
    check();
    plate.places.clear();
    plate.phases.clear();
    check();
}

} // namespace meltpool
