// The capacity of the flow's lists: they fit the moving metal and grow with it, without effect on the results.
#include "core/validation/flow_rig.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

namespace meltpool {

namespace {

constexpr double kSpacing = 1e-3;
constexpr double kFrame = 1.0 / 90;

/// Makes a block of wall metal, 18 x 12 x 18 particles, in a space with room around it.
FlowRig solidBlock() {
    std::vector<MetalSeed> seeds;
    addBlock(seeds, glm::vec3(0), glm::vec3(18e-3F, 12e-3F, 18e-3F), kSpacing, false);
    FlowFluid fluid;
    fluid.spacing = kSpacing;
    return FlowRig(test::shaders(), fluid, {glm::vec3(-8e-3F), glm::vec3(26e-3F)}, glm::vec3(0), seeds);
}

void setPhases(FlowRig& bench, const std::function<unsigned(const glm::vec3&)>& phaseAt) {
    const auto places = bench.state.position.read<vec4>(bench.liquid.size());
    auto phases = bench.state.phase.read<uint>(bench.liquid.size());
    for (size_t i = 0; i < places.size(); ++i) {
        phases[i] = PHASE_ALIVE | phaseAt(glm::vec3(places[i]));
        bench.liquid[i] = (phases[i] & PHASE_LIQUID) != 0;
    }
    bench.state.phase.write(std::span<const uint>(phases));
    bench.state.noteRegrouping();
}

/// Returns the largest error of the density of liquid against the sum over all pairs.
double densityError(const FlowRig& bench) {
    const auto computed = bench.flow.readParticles();
    std::vector<OracleParticle> particles;
    for (const FlowParticle& particle : computed)
        particles.push_back({glm::dvec3(particle.position)});
    FlowOracle(bench.fluid).sweepDensity(particles);
    double most = 0;
    for (size_t i = 0; i < computed.size(); ++i)
        if (bench.liquid[i])
            most = std::max(most, std::abs(static_cast<double>(computed[i].density) - particles[i].delta));
    return most;
}

} // namespace

TEST_CASE("neighbour lists grow with what melts and miss nobody") {
    test::context();
    FlowRig bench = solidBlock();
    bench.run(kFrame, kFrame);
    const size_t before = bench.flow.bytes();
    for (int layer = 11; layer >= 0; --layer) {
        setPhases(bench, [&](const glm::vec3& place) {
            return place.y > static_cast<float>(layer) * 1e-3F ? PHASE_LIQUID : 0U;
        });
        bench.run(kFrame, kFrame);
        INFO("layer " << layer);
        CHECK_FALSE(bench.flow.readFaults().any());
        CHECK(densityError(bench) < 1e-3);
    }
    CHECK(bench.flow.readMoving() == bench.liquid.size());
    CHECK(bench.flow.bytes() > before + bench.liquid.size() * 200);
}

TEST_CASE("a fragment that comes loose at once needs no neighbour lists") {
    test::context();
    FlowRig bench = solidBlock();
    const auto drop = [](const glm::vec3& place) {
        return glm::length(place - glm::vec3(9e-3F, 12e-3F, 9e-3F)) < 3.2e-3F ? PHASE_LIQUID : 0U;
    };
    setPhases(bench, drop);
    bench.run(2 * kFrame, kFrame);
    const size_t before = bench.flow.bytes();
    setPhases(bench,
              [&](const glm::vec3& place) { return drop(place) != 0 ? PHASE_LIQUID : 1U << PHASE_FRAGMENT_SHIFT; });
    bench.run(2 * kFrame, kFrame);
    CHECK(bench.flow.readMoving() == bench.liquid.size());
    CHECK(bench.flow.bytes() == before);
    CHECK_FALSE(bench.flow.readFaults().any());
    CHECK(densityError(bench) < 1e-3);
}

TEST_CASE("liquid that spreads into new cells finds room in them") {
    test::context();
    std::vector<MetalSeed> seeds;
    addBlock(seeds, glm::vec3(-5e-3F), glm::vec3(5e-3F), kSpacing, true);
    for (MetalSeed& seed : seeds)
        seed.velocity = 100.0F * seed.position; // 0.5 m/s at the faces
    FlowFluid fluid;
    fluid.spacing = kSpacing;
    fluid.tension = 0.01;
    fluid.fastest = 1;
    FlowRig bench(test::shaders(), fluid, {glm::vec3(-0.05F), glm::vec3(0.05F)}, glm::vec3(0), seeds);
    bench.run(kFrame / 4, kFrame / 4);
    bench.run(4 * kFrame, kFrame / 4);
    CHECK_FALSE(bench.flow.readFaults().any());
    CHECK(densityError(bench) < 1e-3);
}

} // namespace meltpool
