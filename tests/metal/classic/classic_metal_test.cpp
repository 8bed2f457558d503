// The classic model as a whole: immobile solid, repeatable bits, no loss of particles, and reported faults.
#include "core/base/error.hpp"
#include "tests/metal/classic/classic_twin.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace meltpool {

namespace {

bool sameBits(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec4)) == 0;
}

const ClassicSource kCornerFlame{{0.55F, 0.55F, 0.55F}, 1.0F, false};

void run(ClassicMetal& metal, int steps, const ClassicSource& source) {
    for (int i = 0; i < steps; ++i)
        metal.step(source, nullptr);
}

void checkWhole(ClassicMetal& metal) {
    const MetalStatistics found = metal.statistics();
    CHECK(found.lost == 0);
    CHECK(found.nonFinite == 0);
    for (const glm::vec4& p : metal.snapshot().positions)
        if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 1)) FAIL("a particle is outside the box");
}

} // namespace

TEST_CASE("a solid cube does not move by one bit") {
    for (const int arrangement : {ClassicSetup::kOrdered, ClassicSetup::kRandom}) {
        ClassicMetal metal(test::shaders(), {20032, arrangement, 1});
        const auto before = metal.snapshot().positions;
        const auto hash = metal.stateHash();
        run(metal, 60, {glm::vec3(0.9F), 1.0F, false}); // out of the flame's reach
        CHECK(sameBits(metal.snapshot().positions, before));
        CHECK(metal.stateHash() == hash);
    }
}

TEST_CASE("a flame at one corner melts that corner only, and off it freezes again") {
    ClassicMetal metal(test::shaders(), {8192, ClassicSetup::kOrdered, 1});
    metal.parameters.heatRadius = 0.25F;
    const auto before = metal.snapshot().positions;
    run(metal, 60, kCornerFlame);
    const auto hot = metal.snapshot().positions;
    const MetalStatistics melted = metal.statistics();
    CHECK(melted.molten > 100);
    CHECK(melted.molten < 4000);
    CHECK(melted.maxTemperature > 0.9);
    CHECK(melted.minTemperature == 0);
    for (size_t i = 0; i < before.size(); ++i) // the half away from the flame is bitwise unchanged
        if (before[i].x + before[i].y + before[i].z < 0) {
            if (std::memcmp(&before[i], &hot[i], sizeof before[i]) != 0) FAIL("particle " << i << " has changed");
        }
    metal.parameters.solidifyRate = 0.05F;
    run(metal, 30, {});
    CHECK(metal.statistics().molten == 0);
    const auto hash = metal.stateHash();
    run(metal, 5, {});
    CHECK(metal.stateHash() == hash);
}

TEST_CASE("the same run gives the same bits, after a reset too") {
    ClassicMetal first(test::shaders(), {20032, ClassicSetup::kRandom, 3});
    ClassicMetal second(test::shaders(), {20032, ClassicSetup::kRandom, 3});
    const auto start = first.stateHash();
    run(first, 40, kCornerFlame);
    run(second, 20, kCornerFlame);
    const auto middle = second.snapshot();
    run(second, 20, kCornerFlame);
    const auto end = first.stateHash();
    CHECK(end != start);
    CHECK(second.stateHash() == end);
    first.reset();
    CHECK(first.stateHash() == start);
    run(first, 40, kCornerFlame);
    CHECK(first.stateHash() == end);
    first.restore(middle);
    run(first, 20, kCornerFlame);
    CHECK(first.stateHash() == end);
}

TEST_CASE("odd numbers of particles lose nobody and stay finite") {
    for (const int count : {1, 2, 63, 64, 65, 1234, 8191, 8193}) {
        CAPTURE(count);
        ClassicMetal metal(test::shaders(), {count, ClassicSetup::kOrdered, 1});
        metal.parameters.heatRadius = 1;
        run(metal, 90, {glm::vec3(0), 1.0F, false});
        CHECK(metal.statistics().particles == size_t(count));
        checkWhole(metal);
    }
}

TEST_CASE("wild parameters stay finite and inside the box") {
    ClassicMetal metal(test::shaders(), {4096, ClassicSetup::kRandom, 1});
    auto state = metal.snapshot();
    for (glm::vec4& p : state.positions)
        p.w = 1;
    for (const float value : {0.0F, 1.0F}) { // every live parameter at its least and at its largest
        metal.restore(state);
        ParameterList list = describe(metal.parameters);
        for (const Parameter& p : list)
            if (auto* const* number = std::get_if<float*>(&p.value); number != nullptr && p.key != "support_radius")
                **number = float(p.minimum + double(value) * (p.maximum - p.minimum));
        run(metal, 20, kCornerFlame);
        CHECK(metal.statistics().lost == 0);
        CHECK(metal.statistics().maxTemperature <= 1);
    }
}

TEST_CASE("a state that is no number is refused and reported") {
    ClassicMetal metal(test::shaders(), {65, ClassicSetup::kOrdered, 1});
    auto state = metal.snapshot();
    for (glm::vec4& p : state.positions)
        p.w = 1;
    state.velocities[7].y = std::numeric_limits<float>::quiet_NaN();
    state.velocities[9].x = std::numeric_limits<float>::infinity();
    metal.restore(state);
    run(metal, 10, {});
    const MetalStatistics found = metal.statistics();
    CHECK(found.nonFinite >= 2);
    CHECK(found.lost == 0);
    const auto after = metal.snapshot();
    for (size_t i = 0; i < after.positions.size(); ++i)
        for (int axis = 0; axis < 4; ++axis) {
            CHECK(std::isfinite(after.positions[i][axis]));
            CHECK(std::isfinite(after.velocities[i][axis]));
        }
    metal.reset();
    CHECK(metal.statistics().nonFinite == 0);
}

TEST_CASE("statistics agree with the particles, waited for or not") {
    for (const int count : {1, 63, 65, 1234, 20032}) {
        CAPTURE(count);
        ClassicMetal metal(test::shaders(), {count, ClassicSetup::kOrdered, 1});
        auto state = test::livelyState(size_t(count), 1.0, 2);
        if (count > 1) state.positions.back().x = 1.5F; // one particle outside the box
        metal.restore(state);
        MetalStatistics expected{size_t(count), 0, count > 1 ? size_t(1) : size_t(0), 0, 2, 0, -1};
        for (const glm::vec4& p : state.positions) {
            expected.molten += p.w > 0 ? 1U : 0U;
            expected.minTemperature = std::min(expected.minTemperature, double(p.w));
            expected.maxTemperature = std::max(expected.maxTemperature, double(p.w));
            expected.meanTemperature += double(p.w) / count;
        }
        const auto check = [&expected](const MetalStatistics& found) {
            CHECK(found.particles == expected.particles);
            CHECK(found.molten == expected.molten);
            CHECK(found.lost == expected.lost);
            CHECK(found.nonFinite == 0);
            CHECK(found.minTemperature == expected.minTemperature);
            CHECK(found.maxTemperature == expected.maxTemperature);
            CHECK(found.meanTemperature == Approx(expected.meanTemperature).epsilon(1e-5));
        };
        check(metal.statistics());
        CHECK_FALSE(metal.pollStatistics());
        for (size_t i = 0; i < kStatisticsInFlight; ++i)
            metal.requestStatistics();
        CHECK_THROWS_AS(metal.requestStatistics(), RuntimeFault);
        glFinish();
        for (size_t i = 0; i < kStatisticsInFlight; ++i) {
            const auto polled = metal.pollStatistics();
            REQUIRE(polled);
            check(*polled);
        }
        CHECK_FALSE(metal.pollStatistics());
        CHECK_FALSE(metal.awaitStatistics());
    }
}

TEST_CASE("what the points view sees is every particle") {
    ClassicMetal metal(test::shaders(), {1234, ClassicSetup::kRandom, 1});
    run(metal, 3, kCornerFlame);
    const ParticleView view = metal.particles();
    REQUIRE(view.count == 1234);
    auto seen = view.positions->read<glm::vec4>(view.count);
    auto all = metal.snapshot().positions;
    const auto less = [](const glm::vec4& a, const glm::vec4& b) {
        return std::lexicographical_compare(&a.x, &a.x + 4, &b.x, &b.x + 4);
    };
    std::sort(seen.begin(), seen.end(), less);
    std::sort(all.begin(), all.end(), less);
    CHECK(sameBits(seen, all));
}

TEST_CASE("a particle takes at most 160 bytes") {
    for (const int count : {8192, 20032})
        for (const float h : {0.01F, 0.05F, 0.1F}) {
            ClassicMetal metal(test::shaders(), {count, ClassicSetup::kOrdered, 1});
            metal.parameters.supportRadius = h;
            metal.step({}, nullptr);
            CHECK(double(metal.bytes()) / count <= 160);
        }
}

} // namespace meltpool
