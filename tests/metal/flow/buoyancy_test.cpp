// Buoyancy and heat transport: hot liquid rises, and moving liquid carries its heat and spreads it by conduction alone.
#include "core/metal/flow/flow.hpp"
#include "core/validation/heat_rig.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace meltpool {

namespace {

constexpr float kSpacing = 1e-3F;
constexpr float kHot = 2000;

Material plainMetal() {
    Material m;
    m.solidus = m.liquidus = 1000;
    m.latentHeat = 1e5;
    m.solidDensity = m.liquidDensity = Property::constant(7000);
    m.solidConductivity = m.liquidConductivity = Property::constant(30);
    m.solidSpecificHeat = m.liquidSpecificHeat = Property::constant(30 / (7000 * 6e-6));
    m.emissivity = Property::constant(0);
    return m;
}

FlowFluid expanding() {
    FlowFluid fluid;
    fluid.tension = 0;
    fluid.fastest = 0.1;
    fluid.expansion = 1e-4;
    fluid.referenceTemperature = 1500;
    return fluid;
}

/// Returns the mean velocity after 0.01 s of metal that starts at rest.
glm::dvec3 velocityAfter(const std::vector<MetalSeed>& seeds, const FlowSpace& space) {
    MetalState state(MetalLattice::covering(space.low, space.high, kSpacing), HeatTable(plainMetal()), 7000,
                     seeds.size());
    state.setGravity({0, -9.81F, 0});
    state.add(seeds);
    Flow flow(test::shaders(), state, expanding(), space);
    flow.step(0.01, nullptr);
    glm::dvec3 sum(0);
    for (const vec4& v : state.velocity.read<vec4>(seeds.size()))
        sum += glm::dvec3(v) / static_cast<double>(seeds.size());
    return sum;
}

/// Returns the places of liquid that is shaken by up to `shake` spacings and settles for `seconds`, in a box that
/// repeats along every axis.
std::vector<vec4> settled(std::vector<MetalSeed> seeds, glm::vec3 low, glm::vec3 high, float shake, double seconds) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> offset(-shake * kSpacing, shake * kSpacing);
    for (MetalSeed& seed : seeds) {
        seed.phase = PHASE_ALIVE | PHASE_LIQUID;
        seed.position += glm::vec3(offset(random), offset(random), offset(random));
    }
    MetalState state(MetalLattice::covering(low, low, kSpacing), HeatTable(plainMetal()), 7000, seeds.size());
    state.setGravity(glm::vec3(0));
    state.add(seeds);
    Flow flow(test::shaders(), state, expanding(), {low, high, glm::bvec3(true), glm::vec3(0)});
    if (seconds > 0) flow.step(seconds, nullptr);
    return state.position.read<vec4>(seeds.size());
}

/// Returns the diffusivity whose step profile around `edge` best fits the temperatures after `seconds`.
double fittedDiffusivity(const std::vector<vec4>& places, double edge, double seconds) {
    double best = 0, least = 1e300;
    for (double alpha = 2e-6; alpha < 2e-5; alpha *= 1.005) {
        double sum = 0;
        for (const vec4& p : places) {
            const double x = static_cast<double>(p.x) - edge;
            const double exact = 1300 + 100 * std::erf(x / std::sqrt(4 * alpha * seconds));
            sum += std::pow(static_cast<double>(p.w) - exact, 2);
        }
        if (sum >= least) continue;
        least = sum;
        best = alpha;
    }
    return best;
}

} // namespace

TEST_CASE("Hot liquid is lighter by its expansion, and what flies is not", "[flow][buoyancy]") {
    test::context();
    FlowSpace space{glm::vec3(0), glm::vec3(8 * kSpacing), glm::bvec3(true), glm::vec3(0)};
    std::vector<MetalSeed> full;
    for (int i = 0; i < 512; ++i)
        full.push_back(
            {(glm::vec3(i % 8, i / 8 % 8, i / 64) + 0.5F) * kSpacing, kHot, PHASE_ALIVE | PHASE_LIQUID, glm::vec3(0)});
    // At 500 K above the temperature of full weight, liquid is 5 % lighter.
    CHECK(velocityAfter(full, space).y == Approx(-0.0981 * 0.95).epsilon(1e-4));
    // Without the hydrostatic part, the remaining force lifts.
    space.acceleration = {0, 9.81F, 0};
    CHECK(velocityAfter(full, space).y == Approx(0.0981 * 0.05).epsilon(1e-4));
    space.acceleration = {0, 0, 0};
    const std::vector<MetalSeed> drop(full.begin(), full.begin() + 1);
    CHECK(velocityAfter(drop, space).y == Approx(-0.0981).epsilon(1e-4));
}

TEST_CASE("Liquid that moves takes its heat along and spreads it by conduction alone", "[heat][loose][buoyancy]") {
    test::context();
    const double settling = GENERATE(0.0, 0.3);
    const float speed = GENERATE(0.0F, 3e-3F, 3e-2F); // m/s: up to 30 spacings a second
    constexpr double kSeconds = 0.8;
    const float way = speed * static_cast<float>(kSeconds);
    const glm::vec3 low(4 * kSpacing), high(0.036F, 0.012F, 0.012F);
    const MetalLattice lattice =
        MetalLattice::covering(glm::vec3(0), high + glm::vec3(way, 0, 0) + 4 * kSpacing, kSpacing);
    const float edge = 0.02F;
    auto seeds = latticeSeeds(lattice, low, high, 1200);
    const auto start = settled(seeds, low, high, 0.3F, settling);
    for (size_t i = 0; i < seeds.size(); ++i) {
        seeds[i].phase = PHASE_ALIVE | PHASE_LIQUID;
        seeds[i].position = glm::vec3(start[i]);
        if (seeds[i].position.x > edge) seeds[i].temperature = 1400;
    }
    HeatSettings settings;
    settings.meltedLeaves = true;
    HeatRig bench(test::shaders(), lattice, plainMetal(), seeds, settings);
    const double before = bench.state.readEnergy();
    const double longest = bench.solver.longestStep(1400);
    const int steps = static_cast<int>(std::ceil(kSeconds / longest));
    for (int i = 0; i < steps; ++i) {
        bench.solver.step(kSeconds / steps, {});
        auto places = bench.state.position.read<vec4>(seeds.size());
        for (vec4& place : places)
            place.x += way / static_cast<float>(steps);
        bench.state.position.write(std::span<const vec4>(places));
    }
    CHECK(bench.state.readEnergy() == Approx(before).epsilon(3e-7));
    const double alpha =
        fittedDiffusivity(bench.state.position.read<vec4>(seeds.size()), static_cast<double>(edge + way), kSeconds);
    INFO("settled for " << settling << ", at " << speed << " m/s: " << alpha << " of 6e-6 m²/s");
    CHECK(alpha == Approx(6e-6).epsilon(0.03));
}

} // namespace meltpool
