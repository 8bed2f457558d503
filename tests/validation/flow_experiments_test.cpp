// Small versions of the flow's experiments: drops, pools and plates agree with theory.
#include "core/validation/exact_solutions.hpp"
#include "core/validation/flow_experiments.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace meltpool {

TEST_CASE("the damped fit finds frequency and decay") {
    std::vector<double> samples;
    for (int i = 0; i < 100; ++i)
        samples.push_back(3 + std::exp(-4 * i * 2e-3) * std::sin(2 * std::numbers::pi * 21 * i * 2e-3 + 0.4));
    const DampedFit fit = fitDamped(samples, 2e-3, 10, 40);
    CHECK(fit.frequency == Approx(21).epsilon(1e-3));
    CHECK(fit.decay == Approx(4).epsilon(0.02));
}

TEST_CASE("constants follow from the liquid") {
    FlowFluid steel;
    const FlowConstants constants = FlowConstants::of(steel);
    CHECK(constants.soundSpeed == Approx(1.77).epsilon(0.01));
    CHECK(constants.substeps(1.0 / 90) == 14);
    FlowFluid fine = steel;
    fine.spacing = 0.5e-3;
    CHECK(FlowConstants::of(fine).substeps(1.0 / 90) < 42);
    CHECK(arcPressurePeak(200, 2e-3) == Approx(4e-3 / (2 * std::numbers::pi * 4e-6)));
    CHECK(capillarySpacings(steel) == Approx(5.12).epsilon(0.01));
    CHECK(capillarySpacings(fine) == Approx(2 * capillarySpacings(steel)));
    for (const double spacings : {1.0, 5.0, 7.1, 10.0}) {
        CHECK(wettingForAngle(0, spacings) == 1);
        CHECK(wettingForAngle(std::numbers::pi, spacings) == 0);
        for (double angle = 0; angle < 3.1; angle += 0.1)
            CHECK(wettingForAngle(angle, spacings) >= wettingForAngle(angle + 0.04, spacings));
    }
    CHECK(wettingForAngle(1.7, 10) > wettingForAngle(1.7, 5));
    CHECK(wettingForAngle(1.7, 5) == wettingForAngle(1.7, 1));
}

TEST_CASE("a drop's highest point is found from particles in any order and wherever its axis is") {
    const double spacing = GENERATE(1e-3, 0.5e-3);
    const double radius = GENERATE(3e-3, 6e-3);
    INFO("spacing " << spacing << ", radius " << radius);
    const glm::dvec3 axis(0.3e-3, 0, -0.2e-3);
    // The start is half a ball on the plane, its outermost particles half a spacing inside.
    std::vector<glm::dvec3> places;
    const int reach = static_cast<int>(radius / spacing) + 1;
    for (int x = -reach; x <= reach; ++x)
        for (int z = -reach; z <= reach; ++z) {
            const double across = spacing * std::hypot(x, z);
            if (across > radius - spacing / 2) continue;
            const double top = std::sqrt((radius - spacing / 2) * (radius - spacing / 2) - across * across);
            for (double y = top; y > 0; y -= spacing)
                places.push_back(axis + glm::dvec3(x * spacing, y, z * spacing));
        }
    CHECK(apexHeight(places, spacing) == Approx(radius).epsilon(0.02));
}

TEST_CASE("drops from four spacings in radius on swing at Rayleigh's frequency") {
    const FlowFluid steel;
    const double radius = GENERATE(4e-3, 5e-3, 6e-3);
    INFO("radius " << radius);
    const DropletOscillation drop = dropletOscillation(test::shaders(), steel, radius, 0.1);
    const double exact = exact::dropletFrequency(steel.tension, steel.density, radius);
    CHECK(drop.frequency == Approx(exact).epsilon(0.04));
    CHECK_FALSE(drop.faults.any());
}

TEST_CASE("a drop's pressure is Laplace's") {
    FlowFluid water;
    water.density = 1000;
    water.tension = 0.072;
    water.viscosity = 1e-3;
    const DropletPressure drop = dropletPressure(test::shaders(), water, 6e-3, 0.4);
    CHECK(drop.jump == Approx(exact::dropletPressure(water.tension, 6e-3)).epsilon(0.1));
    CHECK(drop.density == Approx(1).epsilon(0.03));
    CHECK_FALSE(drop.faults.any());
}

TEST_CASE("a drop on a wall is as many particles as its volume holds") {
    const FlowFluid steel;
    const auto particles = [&](double volume) {
        return sessileDrop(test::shaders(), steel, volume * 1e-9, 9.81, 0.02).particles;
    };
    CHECK(particles(31) == particles(30) + 1);
    CHECK(particles(34) == particles(30) + 4);
}

TEST_CASE("a pool's pressure grows with depth, and it comes to rest") {
    FlowFluid steel;
    const double height = 10e-3;
    const HydrostaticColumn column = hydrostaticColumn(test::shaders(), steel, height, 9.81, 0.5);
    CHECK(column.bottomPressure == Approx(steel.density * 9.81 * height).epsilon(0.03));
    CHECK(column.densityError < 0.03);
    CHECK(column.restSpeed < 6e-3); // surface tension causes a constant tremble of the particles
    CHECK_FALSE(column.faults.any());
}

TEST_CASE("a pool 10 mm deep comes to rest in a box") {
    const FlowFluid steel;
    const auto dx = static_cast<float>(steel.spacing);
    const glm::vec3 low(-3 * dx), high = glm::vec3(13, 16, 13) * dx;
    std::vector<MetalSeed> block, seeds;
    addBlock(block, low, {high.x, 11 * dx, high.z}, steel.spacing, false);
    for (const MetalSeed& seed : block) {
        const glm::vec3 p = seed.position;
        const bool inside = p.x > 0 && p.x < 10 * dx && p.z > 0 && p.z < 10 * dx && p.y > 0;
        if (!inside) seeds.push_back(seed);
    }
    addBlock(seeds, glm::vec3(0), glm::vec3(10 * dx), steel.spacing, true);
    FlowRig bench(test::shaders(), steel, {low, high}, glm::vec3(0, -9.81F, 0), seeds);
    bench.run(1.6, 1.0 / 90);
    double sum = 0;
    const auto velocities = bench.readVelocities();
    for (const glm::dvec3& velocity : velocities)
        sum += glm::dot(velocity, velocity);
    CHECK(std::sqrt(sum / static_cast<double>(velocities.size())) <= 3e-3);
    CHECK_FALSE(bench.flow.readFaults().any());
}

TEST_CASE("flow between plates starts up as the series says") {
    FlowFluid oil;
    oil.tension = 0;
    oil.viscosity = 0.5;
    oil.leastViscosity = 0;
    oil.fastest = 0.01;
    const double gap = 10e-3, force = 100, time = 0.1;
    const PlateFlow flow = plateFlow(test::shaders(), oil, gap, force, time);
    const double centre = exact::poiseuille(force, oil.viscosity, oil.density, gap, gap / 2, time);
    double worst = 0;
    for (size_t i = 0; i < flow.places.size(); ++i) {
        const double exact = exact::poiseuille(force, oil.viscosity, oil.density, gap, flow.places[i], time);
        worst = std::max(worst, std::abs(flow.velocities[i] - exact) / centre);
    }
    CHECK(worst < 0.05); // ten particles across the gap
    CHECK_FALSE(flow.faults.any());
}

} // namespace meltpool
