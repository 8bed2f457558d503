// Drops in space: forces are equal and opposite to the bit, so momentum changes by rounding alone, and neighbour lists
// that serve several substeps contain every near particle.
#include "core/validation/flow_rig.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <random>

namespace meltpool {

namespace {

constexpr float kSpacing = 1e-3F;

/// Adds a shaken ball of liquid: places by a tenth of a spacing, velocities (m/s) by 0.01 an axis.
void addBall(std::vector<MetalSeed>& seeds, glm::vec3 centre, float radius, glm::vec3 velocity, std::mt19937& random) {
    std::uniform_real_distribution<float> shake(-0.1F, 0.1F);
    const auto shaken = [&] { return glm::vec3(shake(random), shake(random), shake(random)); };
    std::vector<MetalSeed> cube;
    addBlock(cube, glm::vec3(-radius), glm::vec3(radius), static_cast<double>(kSpacing), true);
    for (MetalSeed& seed : cube) {
        if (glm::length(seed.position) > radius) continue;
        seed.position += centre + kSpacing * shaken();
        seed.velocity = velocity + 0.1F * shaken();
        seeds.push_back(seed);
    }
}

/// Returns a ball of 560 particles.
std::vector<MetalSeed> oneDrop() {
    std::mt19937 random(11);
    std::vector<MetalSeed> seeds;
    addBall(seeds, glm::vec3(0), 5 * kSpacing, glm::vec3(0.02F, -0.01F, 0.03F), random);
    return seeds;
}

/// Returns two balls that collide off centre at 0.3 m/s and together drift slowly sideways.
std::vector<MetalSeed> twoDrops() {
    std::mt19937 random(12);
    std::vector<MetalSeed> seeds;
    const glm::vec3 off = glm::vec3(5.2F, 1.5F, 0) * kSpacing, aside(0.02F, -0.01F, 0.03F), against(0.15F, 0, 0);
    addBall(seeds, off, 4 * kSpacing, aside - against, random);
    addBall(seeds, -off, 4 * kSpacing, aside + against, random);
    return seeds;
}

/// Sums over the particles for a particle mass of 1.
struct Momenta {
    glm::dvec3 linear{0}, angular{0};  ///< angular momentum about the origin
    double ofSpeeds = 0, ofLevers = 0; ///< sums of absolute values
};

Momenta momentaOf(const FlowRig& bench) {
    Momenta sums;
    const auto places = bench.readPositions(), velocities = bench.readVelocities();
    for (size_t i = 0; i < places.size(); ++i) {
        sums.linear += velocities[i];
        sums.angular += glm::cross(places[i], velocities[i]);
        sums.ofSpeeds += glm::length(velocities[i]);
        sums.ofLevers += glm::length(places[i]) * glm::length(velocities[i]);
    }
    return sums;
}

/// Mean and largest error of the density ratio from lists, against the ratio from all pairs.
struct DensityErrors {
    double mean = 0, most = 0;
};

DensityErrors densityErrors(const FlowRig& bench) {
    const auto computed = bench.flow.readParticles();
    std::vector<OracleParticle> particles;
    for (const FlowParticle& particle : computed)
        particles.push_back({glm::dvec3(particle.position)});
    FlowOracle(bench.fluid).sweepDensity(particles);
    DensityErrors errors;
    for (size_t i = 0; i < computed.size(); ++i) {
        const double error = std::abs(static_cast<double>(computed[i].density) - particles[i].delta);
        errors.mean += error / static_cast<double>(computed.size());
        errors.most = std::max(errors.most, error);
    }
    return errors;
}

FlowRig inSpace(const FlowFluid& fluid, const std::vector<MetalSeed>& seeds) {
    return FlowRig(test::shaders(), fluid, {glm::vec3(-0.06F), glm::vec3(0.06F)}, glm::vec3(0), seeds);
}

} // namespace

TEST_CASE("drops in space keep their momentum to float accuracy") {
    test::context();
    const bool collide = GENERATE(false, true);
    INFO((collide ? "two drops collide" : "one drop"));
    FlowRig bench = inSpace({}, collide ? twoDrops() : oneDrop());
    const Momenta before = momentaOf(bench);
    bench.run(0.2, 0.2);
    const Momenta after = momentaOf(bench);
    CHECK(glm::length(after.linear - before.linear) < 1e-6 * before.ofSpeeds);
    CHECK(glm::length(after.angular - before.angular) < 1e-6 * before.ofLevers);
    CHECK(bench.flow.readSearches() < bench.steps * 3 / 4); // lists serve several substeps
    CHECK_FALSE(bench.flow.readFaults().any());
}

TEST_CASE("without surface tension drops that collide keep their angular momentum too") {
    test::context();
    FlowFluid fluid;
    fluid.tension = 0;
    fluid.fastest = 0.3;
    FlowRig bench = inSpace(fluid, twoDrops());
    const Momenta before = momentaOf(bench);
    bench.run(0.05, 0.05);
    const Momenta after = momentaOf(bench);
    CHECK(glm::length(after.linear - before.linear) < 1e-6 * before.ofSpeeds);
    CHECK(glm::length(after.angular - before.angular) < 1e-6 * before.ofLevers);
    CHECK(after.ofSpeeds < 0.9 * before.ofSpeeds); // the balls have collided
    CHECK_FALSE(bench.flow.readFaults().any());
}

TEST_CASE("neighbour lists miss nobody who is near") {
    test::context();
    FlowRig bench = inSpace({}, twoDrops());
    DensityErrors errors;
    double looks = 0;
    bench.run(0.12, 0.01, [&](double) {
        const DensityErrors now = densityErrors(bench);
        errors.mean += now.mean;
        errors.most = std::max(errors.most, now.most);
        looks += 1;
    });
    CHECK(errors.mean < 1e-6 * looks);
    CHECK(errors.most < 1e-3);
}

} // namespace meltpool
