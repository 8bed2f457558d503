// The classic model's passes against their CPU twin and against closed forms.
#include "tests/metal/classic/classic_twin.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

struct Difference {
    double position = 0, velocity = 0, temperature = 0, density = 0; ///< largest differences; density relative
};

Difference compare(const std::vector<test::TwinParticle>& twin, const ClassicMetal::Snapshot& state) {
    Difference most;
    for (size_t i = 0; i < twin.size(); ++i) {
        const auto larger = [](double& value, double other) { value = std::max(value, std::abs(other)); };
        larger(most.position, glm::length(twin[i].position - glm::dvec3(state.positions[i])));
        larger(most.velocity, glm::length(twin[i].velocity - glm::dvec3(state.velocities[i])));
        larger(most.temperature, twin[i].temperature - double(state.positions[i].w));
        larger(most.density, double(state.velocities[i].w) / twin[i].density - 1);
    }
    return most;
}

/// A single particle far from all others.
struct Single {
    explicit Single(glm::vec4 start, glm::vec3 startVelocity = glm::vec3(0)) : metal(test::shaders(), {1, 0, 1}) {
        metal.parameters.solidifyRate = 0;
        metal.parameters.gravity = glm::vec3(0);
        metal.restore({{start}, {glm::vec4(startVelocity, 0)}});
    }
    void step(const ClassicSource& source = {}) {
        metal.step(source, nullptr);
        position = metal.snapshot().positions.front();
        velocity = glm::vec3(metal.snapshot().velocities.front());
    }
    ClassicMetal metal;
    glm::vec4 position{0};
    glm::vec3 velocity{0};
};

} // namespace

TEST_CASE("a step agrees with the CPU twin, with the grid and over all pairs") {
    for (const int count : {1, 63, 65, 1234, 20032})
        for (const bool allPairs : {false, true}) {
            if (allPairs && count > 2000) continue;
            CAPTURE(count, allPairs);
            ClassicMetal metal(test::shaders(), {count, ClassicSetup::kOrdered, 1});
            // The support radius gives about 20 neighbours, a density near rest, and forces on both sides of the limit.
            metal.parameters.supportRadius = 0.05F;
            metal.parameters.particleMass = 0.002F;
            metal.parameters.accelerationLimit = 60;
            metal.parameters.heatRadius = 0.05F;
            const double edge = std::cbrt(double(count)) * 0.03;
            metal.restore(test::livelyState(size_t(count), edge, 11));
            metal.useAllPairs(allPairs);
            const ClassicSource source{glm::vec3(float(edge) / 4), 0.7F, false};
            auto twin = test::twinOf(metal.snapshot());
            metal.step(source, nullptr);
            test::twinStep(twin, metal.parameters, source);
            const Difference difference = compare(twin, metal.snapshot());
            CHECK(difference.density < 1e-4);
            CHECK(difference.temperature < 1e-6);
            CHECK(difference.velocity < 2e-3);
            CHECK(difference.position < 4e-5);
        }
}

TEST_CASE("a row of cells with more particles than the density's pass has bits for agrees with the CPU twin") {
    ClassicMetal metal(test::shaders(), {1234, ClassicSetup::kOrdered, 1});
    metal.parameters.supportRadius = 0.05F;
    metal.parameters.particleMass = 0.0002F;
    metal.parameters.accelerationLimit = 60;
    metal.restore(test::livelyState(1234, 0.2, 13)); // 19 in a cell, 58 in a row of three
    auto twin = test::twinOf(metal.snapshot());
    metal.step({}, nullptr);
    test::twinStep(twin, metal.parameters, {});
    const Difference difference = compare(twin, metal.snapshot());
    CHECK(difference.density < 1e-4);
    CHECK(difference.velocity < 2e-3);
}

TEST_CASE("several steps, with walls, a cold source and a radius that changes, stay with the twin") {
    const int count = 1234;
    ClassicMetal metal(test::shaders(), {count, ClassicSetup::kRandom, 1});
    ClassicParameters& p = metal.parameters;
    p.particleMass = 0.002F;
    p.accelerationLimit = 20;
    p.solidifyRate = 0.01F;
    p.heatRadius = 0.3F;
    p.gravity = {3, -9.81F, 2};
    metal.restore(test::livelyState(size_t(count), 1.9, 12));
    auto twin = test::twinOf(metal.snapshot());
    for (int step = 0; step < 16; ++step) {
        p.supportRadius = step < 8 ? 0.2F : 0.15F;
        p.wallSlip = step % 2 == 1;
        const ClassicSource source{glm::vec3(0.2F), 1.0F, step >= 8};
        metal.step(source, nullptr);
        test::twinStep(twin, p, source);
    }
    const Difference difference = compare(twin, metal.snapshot());
    CHECK(difference.density < 1e-3);
    CHECK(difference.temperature < 1e-4);
    CHECK(difference.position < 1e-3);
}

TEST_CASE("the source heats by the squared distance over the heat radius, up to 1") {
    for (const float distance : {0.0F, 0.1F, 0.2F, 0.29F, 0.31F, 0.5F}) {
        Single single(glm::vec4(distance, 0, 0, 0));
        single.metal.parameters.heatRadius = 0.09F; // distance 0.3, beyond the radius
        single.metal.parameters.heatTemperature = 0.3F;
        const ClassicSource source{glm::vec3(0), 0.5F, false};
        single.step(source);
        const float share = std::max(1 - distance * distance / 0.09F, 0.0F);
        CHECK(single.position.w == Approx(0.15F * share).margin(1e-6));
        for (int i = 0; i < 40; ++i)
            single.step(source);
        CHECK(single.position.w <= 1);
        if (distance < 0.2F) CHECK(single.position.w == 1);
        if (distance > 0.3F) CHECK(single.position.w == 0);
    }
}

TEST_CASE("a cold source takes the same away, down to 0, and what it froze is at rest") {
    Single single({0.1F, 0, 0, 0.9F}, {0.5F, 0, 0});
    single.metal.parameters.heatRadius = 0.09F;
    single.metal.parameters.heatTemperature = 0.3F;
    single.step({glm::vec3(0), 1.0F, true});
    CHECK(single.position.w == Approx(0.9F - 0.3F * (1 - 0.01F / 0.09F)));
    for (int i = 0; i < 10; ++i)
        single.step({glm::vec3(single.position), 1.0F, true});
    CHECK(single.position.w == 0);
    CHECK(single.velocity == glm::vec3(0));
    CHECK(single.position.x > 0.1F);
}

TEST_CASE("an off source changes nothing") {
    Single single({0, 0, 0, 0.5F});
    single.step({glm::vec3(0), 0.0F, false});
    CHECK(single.position.w == 0.5F);
    single.step({glm::vec3(0), 0.0F, true});
    CHECK(single.position.w == 0.5F);
}

TEST_CASE("the solidify rate is taken off at every step and ends at 0") {
    Single single({0, 0, 0, 1.0F});
    single.metal.parameters.solidifyRate = 0.125F;
    for (int step = 1; step <= 10; ++step) {
        single.step();
        CHECK(single.position.w == std::max(1 - 0.125F * float(step), 0.0F));
    }
    CHECK(single.velocity == glm::vec3(0));
}

TEST_CASE("a lone liquid particle falls as the integration says, slowed by its temperature") {
    for (const float temperature : {0.25F, 0.5F, 1.0F}) {
        Single single({0, 0.9F, 0, temperature});
        single.metal.parameters.gravity = {0, -9.81F, 0};
        double velocity = 0, height = double(0.9F);
        for (int i = 0; i < 20; ++i) {
            single.step();
            velocity = (velocity - 9.81 / 60) * double(temperature);
            height += velocity / 60;
        }
        CHECK(double(single.velocity.y) == Approx(velocity).epsilon(1e-4));
        CHECK(double(single.position.y) == Approx(height).epsilon(1e-4));
    }
}

TEST_CASE("acceleration is clamped to its limit and keeps its direction") {
    Single single({0, 0, 0, 1});
    single.metal.parameters.gravity = {30, -40, 0};
    single.metal.parameters.accelerationLimit = 10;
    single.step();
    CHECK(single.velocity.x == Approx(6.0F / 60));
    CHECK(single.velocity.y == Approx(-8.0F / 60));
    CHECK(single.velocity.z == 0);
}

TEST_CASE("each wall puts a particle back and reverses what is left of its velocity") {
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0F, 1.0F})
            for (const bool slip : {false, true}) {
                glm::vec3 place(0.1F), velocity(0.5F, 0.25F, -0.5F);
                place[axis] = side * 0.999F;
                velocity[axis] = side * 2;
                Single single({place, 1}, velocity);
                single.metal.parameters.wallSlip = slip;
                single.step();
                CHECK(single.position[axis] == side);
                for (int other = 0; other < 3; ++other) {
                    const bool reversed = other == axis || !slip;
                    CHECK(single.velocity[other] == Approx(velocity[other] * (reversed ? -0.3F : 1.0F)));
                }
            }
}

TEST_CASE("two particles push each other apart with opposite accelerations") {
    ClassicMetal metal(test::shaders(), {2, ClassicSetup::kOrdered, 1});
    metal.parameters.gravity = glm::vec3(0);
    metal.parameters.restDensity = 0;
    metal.parameters.solidifyRate = 0;
    metal.parameters.accelerationLimit = 100000;
    metal.restore({{{-0.01F, 0, 0, 1}, {0.01F, 0, 0, 1}}, {glm::vec4(0), glm::vec4(0)}});
    metal.step({}, nullptr);
    const auto state = metal.snapshot();
    CHECK(state.velocities[0].x < 0);
    CHECK(state.velocities[0].x == -state.velocities[1].x);
    CHECK(state.velocities[0].y == 0);
}

TEST_CASE("two particles in one place stay finite") {
    ClassicMetal metal(test::shaders(), {2, ClassicSetup::kOrdered, 1});
    metal.restore({{glm::vec4(0.1F, 0, 0, 1), glm::vec4(0.1F, 0, 0, 1)}, {glm::vec4(0), glm::vec4(0)}});
    for (int i = 0; i < 10; ++i)
        metal.step({}, nullptr);
    CHECK(metal.statistics().nonFinite == 0);
    CHECK(metal.statistics().lost == 0);
}

} // namespace meltpool
