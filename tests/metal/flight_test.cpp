// Metal in flight: a drop that freezes in the air continues its motion until it melts again, and a falling drop is
// caught.
#include "core/metal/physical_metal.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;

/// A clamped plate of 30 x 30 mm, 4 mm thick, its top at y = 0, below 40 mm of air.
PhysicalSetup plateBelowAir(glm::vec3 gravity) {
    PhysicalSetup setup;
    setup.material = shippedMaterial("s235");
    const glm::vec3 low = glm::vec3(-15, -4, -15) * kMm, high = glm::vec3(15, 40, 15) * kMm;
    setup.lattice = MetalLattice::covering(low, high, kMm);
    setup.seeds = latticeSeeds(setup.lattice, low, glm::vec3(15, 0, 15) * kMm, 293.15F, PHASE_CLAMPED);
    setup.space = {low, high};
    setup.fragments.floorHeight = low.y;
    setup.fragments.low = low;
    setup.fragments.high = high;
    setup.fillerRoom = 200;
    setup.gravity = gravity;
    return setup;
}

/// A ball of some 60 particles that flies and turns.
std::vector<MetalSeed> ball(glm::vec3 centre, glm::vec3 velocity, glm::vec3 spin, float temperature, unsigned phase) {
    std::vector<MetalSeed> seeds;
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = -3; z <= 3; ++z) {
                const glm::vec3 arm = glm::vec3(x, y, z) * kMm;
                if (glm::length(arm) > 2.5F * kMm) continue;
                seeds.push_back({centre + arm, temperature, phase, velocity + glm::cross(spin, arm)});
            }
    return seeds;
}

struct Motion {
    glm::dvec3 velocity{0};          // velocity of the centre, m/s
    glm::dvec3 spin{0};              // angular momentum about the centre over the mass, m²/s
    glm::dvec3 centre{0};            // m
    size_t liquid = 0, fragment = 0; // numbers of particles
};

/// Returns the motion of the particles from slot `first` on.
Motion motionOf(const PhysicalMetal& metal, size_t first) {
    const MetalState& state = metal.state();
    const size_t count = state.particles();
    const auto places = state.position.read<vec4>(count);
    const auto velocities = state.velocity.read<vec4>(count);
    const auto phases = state.phase.read<uint>(count);
    Motion motion;
    const auto share = 1 / static_cast<double>(count - first);
    for (size_t i = first; i < count; ++i) {
        motion.centre += share * glm::dvec3(places[i]);
        motion.velocity += share * glm::dvec3(velocities[i]);
        motion.liquid += (phases[i] & PHASE_LIQUID) != 0 ? 1 : 0;
        motion.fragment += (phases[i] & PHASE_FRAGMENT_BITS) != 0 ? 1 : 0;
    }
    for (size_t i = first; i < count; ++i)
        motion.spin += share * glm::cross(glm::dvec3(places[i]) - motion.centre, glm::dvec3(velocities[i]));
    return motion;
}

} // namespace

TEST_CASE("what freezes in the air flies and turns on as it did", "[physical][flight]") {
    test::context();
    PhysicalSetup setup = plateBelowAir(glm::vec3(0));
    setup.heat.convection = 2e4; // freezes within some tenths of a second
    PhysicalMetal metal(test::shaders(), setup);
    const size_t first = setup.seeds.size();
    const glm::vec3 velocity(0, 0.01F, 0), spin(0, 10, 15);
    metal.step({}, ball(glm::vec3(0, 10, 0) * kMm, velocity, spin, 1850, PHASE_ALIVE | PHASE_LIQUID), nullptr);
    const Motion before = motionOf(metal, first);
    REQUIRE(before.liquid > 50);
    size_t leastLiquid = before.liquid;
    for (int frame = 0; frame < 60; ++frame) {
        metal.step({}, {}, nullptr);
        const Motion now = motionOf(metal, first);
        leastLiquid = std::min(leastLiquid, now.liquid);
        INFO("frame " << frame << ", liquid " << now.liquid << ", in fragments " << now.fragment << ", speed "
                      << glm::length(now.velocity) << ", spin " << glm::length(now.spin));
        REQUIRE(glm::length(now.velocity - before.velocity) < 0.01 * glm::length(before.velocity));
        REQUIRE(glm::length(now.spin - before.spin) < 0.02 * glm::length(before.spin));
    }
    const Motion after = motionOf(metal, first);
    CHECK(leastLiquid == 0);
    CHECK(after.fragment == metal.state().particles() - first);
    CHECK(after.centre.y ==
          Approx(before.centre.y + 60 * static_cast<double>(metal.timeStep()) * 0.01).epsilon(0).margin(2e-5));
    CHECK(metal.statistics().lost == 0);
}

TEST_CASE("what froze in the air turns on as one piece, and melts again with nothing lost", "[physical][flight]") {
    test::context();
    PhysicalSetup setup = plateBelowAir(glm::vec3(0));
    setup.heat.convection = 2e3; // slow enough to be a fragment first
    setup.heat.ambient = 2600;   // the air melts it
    PhysicalMetal metal(test::shaders(), setup);
    const size_t first = setup.seeds.size();
    const size_t all = ball({}, {}, {}, 0, 0).size();
    const glm::vec3 velocity(0, 0.01F, 0), spin(0, 10, 15);
    // Filler too cold to be liquid freezes in its first step.
    metal.step({}, ball(glm::vec3(0, 10, 0) * kMm, velocity, spin, 1700, PHASE_ALIVE | PHASE_LIQUID), nullptr);
    const Motion before = motionOf(metal, first);
    bool wasFragment = false, melts = false;
    for (int frame = 0; frame < 160; ++frame) {
        metal.step({}, {}, nullptr);
        const Motion now = motionOf(metal, first);
        wasFragment = wasFragment || now.fragment == all;
        melts = melts || now.liquid > 0;
        if (melts) continue; // liquid does not push the fragment that it flows around, so their momenta differ
        INFO("frame " << frame << ", in fragments " << now.fragment);
        REQUIRE(glm::length(now.velocity - before.velocity) < 1e-3 * glm::length(before.velocity));
        REQUIRE(glm::length(now.spin - before.spin) < 1e-3 * glm::length(before.spin));
    }
    CHECK(wasFragment);
    CHECK(motionOf(metal, first).liquid == all);
    CHECK(metal.statistics().lost == 0);
}

TEST_CASE("drops in any state are caught by the plate", "[physical][flight]") {
    test::context();
    const PhysicalSetup setup = plateBelowAir(glm::vec3(0, -9.81F, 0));
    PhysicalMetal metal(test::shaders(), setup);
    const size_t first = setup.seeds.size();
    const float temperature = GENERATE(2400.0F, 1790.0F, 1700.0F); // hot, mushy, solid
    const float speed = GENERATE(0.3F, 1.0F);
    INFO("drops of " << temperature << " K at " << speed << " m/s");
    size_t drops = 0;
    for (int frame = 0; frame < 100; ++frame) {
        std::vector<MetalSeed> drop;
        if (frame < 40 && frame % 2 == 0) {
            const auto turn = static_cast<float>(drops);
            const glm::vec3 place = glm::vec3(6 * std::cos(turn), 15, 6 * std::sin(turn)) * kMm;
            drop.push_back({place, temperature, PHASE_ALIVE | PHASE_LIQUID, {0.1F * speed, -speed, 0}});
            ++drops;
        }
        metal.step({}, drop, nullptr);
    }
    const auto places = metal.state().position.read<vec4>(metal.state().particles());
    const auto velocities = metal.state().velocity.read<vec4>(metal.state().particles());
    CHECK(places.size() - first == drops);
    CHECK(metal.statistics().lost == 0);
    for (size_t i = first; i < places.size(); ++i) {
        INFO("drop " << i - first << " at " << places[i].x << ", " << places[i].y << ", " << places[i].z);
        CHECK(places[i].y > -0.1F * kMm);                         // lowest place between four particles of the plate
        CHECK(places[i].y < (temperature == 1790 ? 5 : 4) * kMm); // on the plate or on other drops; mushy ones pile up
        CHECK(glm::length(glm::vec3(velocities[i])) < 0.02F);
    }
    CHECK_FALSE(metal.flow().readFaults().any());
}

} // namespace meltpool
