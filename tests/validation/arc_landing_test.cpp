// The landing of an arc's heat: geometry in closed form, and what the heat passes really give to the metal.
#include "core/validation/arc_landing.hpp"
#include "core/validation/heat_rig.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <cmath>

using namespace meltpool;

namespace {

constexpr float kSpacing = 1e-3F;
constexpr double kSolidus = 1768;

/// Particles of seeds, as they are read back.
ParticleValues valuesOf(const std::vector<MetalSeed>& seeds) {
    ParticleValues values;
    for (const MetalSeed& seed : seeds) {
        values.positions.emplace_back(seed.position, seed.temperature);
        values.heats.emplace_back(0);
        values.phases.push_back(seed.phase);
    }
    return values;
}

const MetalLattice kLattice = MetalLattice::covering(glm::vec3(-12e-3F), glm::vec3(12e-3F), kSpacing);

std::vector<MetalSeed> plate() {
    return latticeSeeds(kLattice, {-12e-3F, -4e-3F, -12e-3F}, {12e-3F, 0, 12e-3F}, 300);
}

/// A plate, and a wall on it behind z = 0.
std::vector<MetalSeed> corner() {
    auto seeds = plate();
    const auto wall = latticeSeeds(kLattice, {-12e-3F, 0, -12e-3F}, {12e-3F, 12e-3F, 0}, 300);
    seeds.insert(seeds.end(), wall.begin(), wall.end());
    return seeds;
}

HeatSource arcAt(glm::vec3 place, glm::vec3 axis) {
    return HeatSource::gaussian(place, glm::normalize(axis), 2e-3F, 1000).inFront(0.01F, 0.01F).catching(0.25F);
}

const HeatSource kDown = arcAt({0, 0, 0}, {0, -1, 0}), kIntoCorner = arcAt({0, 0, 0}, {0, -1, -1});

} // namespace

TEST_CASE("On a cold plate all of an arc lands on the base plate, half of it ahead", "[validation]") {
    const ArcLanding landing = arcLanding(kLattice, valuesOf(plate()), kDown, kSolidus, false);
    CHECK(landing.caught == Approx(1));
    CHECK(landing.solid == Approx(1));
    CHECK(landing.lying == Approx(1));
    CHECK(landing.standing == 0);
    CHECK(landing.ahead == Approx(0.5).margin(0.001));
}

TEST_CASE("An arc into a cold corner lands on both plates alike", "[validation]") {
    const ArcLanding landing = arcLanding(kLattice, valuesOf(corner()), kIntoCorner, kSolidus, false);
    CHECK(landing.lying == Approx(0.5).margin(0.001));
    CHECK(landing.standing == Approx(0.5).margin(0.001));
}

TEST_CASE("The share of an arc over a melted half of a plate is not on solid metal, and none of it is ahead",
          "[validation]") {
    auto seeds = plate();
    for (MetalSeed& seed : seeds)
        if (seed.position.x > 0) {
            seed.temperature = 2000;
            seed.phase |= PHASE_LIQUID;
        }
    const ArcLanding landing = arcLanding(kLattice, valuesOf(seeds), kDown, kSolidus, false);
    CHECK(landing.solid == Approx(0.5).margin(0.001));
    CHECK(landing.ahead == 0);
}

TEST_CASE("An arc that half misses the plate is caught in part", "[validation]") {
    HeatSource source = kDown;
    source.position.x = 11e-3F; // a plate that ends at 12 mm
    const double half = 0.5 * (1 + std::erf(1e-3 / (2e-3 * std::sqrt(2.0))));
    CHECK(arcLanding(kLattice, valuesOf(plate()), source.catching(1), kSolidus, false).caught ==
          Approx(half).margin(0.06));
}

TEST_CASE("The plates get the shares of an arc's power that its landing says", "[validation]") {
    const Material steel = constantMaterial(shippedMaterial("s235"), 300, 2000);
    const auto seeds = corner();
    const HeatSource source = arcAt({0, 1e-3F, 2e-3F}, {0.2F, -1, -0.6F}); // aslant, more on the base plate
    HeatSettings insulated;
    HeatRig rig(test::shaders(), kLattice, steel, seeds, insulated);
    const auto before = rig.readTemperatures();
    rig.solver.step(1e-4, std::array{source}); // too short for conduction to blur it
    const auto after = rig.readTemperatures();
    double standing = 0, all = 0;
    for (size_t i = 0; i < seeds.size(); ++i) {
        const double rise = after[i] - before[i];
        all += rise;
        if (seeds[i].position.y > 0) standing += rise;
    }
    const ArcLanding landing = arcLanding(kLattice, valuesOf(seeds), source, kSolidus, false);
    REQUIRE(all > 0);
    CHECK(landing.standing > 0.05);
    CHECK(landing.lying > 0.5);
    CHECK(standing / all == Approx(landing.standing).margin(0.01));
}

TEST_CASE("The warmth before the liquid's edge is that of the face there", "[validation]") {
    auto seeds = corner();
    for (MetalSeed& seed : seeds) // 100 K a millimetre along each face
        seed.temperature = 300 + 1e5F * (seed.position.y < 0 ? seed.position.z : seed.position.y);
    for (float x = -5.5e-3F; x < 6e-3F; x += kSpacing)
        for (float out = 0.5e-3F; out < 3e-3F; out += kSpacing)
            seeds.push_back({{x, 0.5e-3F, out}, 2000, PHASE_ALIVE | PHASE_LIQUID});
    for (float x = -5.5e-3F; x < 6e-3F; x += kSpacing)
        seeds.push_back({{x, 1.5e-3F, 0.5e-3F}, 2000, PHASE_ALIVE | PHASE_LIQUID});
    const LineWarmth line = lineWarmth(kLattice, valuesOf(seeds), -4e-3, 4e-3, 0.5e-3);
    REQUIRE(line.lying);
    REQUIRE(line.standing);
    // The outermost particles end at 3 and at 2 mm from the corner.
    CHECK(*line.lying == Approx(300 + 100 * 3.5).margin(1));
    CHECK(*line.standing == Approx(300 + 100 * 2.5).margin(1));
    const LineWarmth none = lineWarmth(kLattice, valuesOf(corner()), -4e-3, 4e-3, 0.5e-3);
    CHECK_FALSE(none.lying);
    CHECK_FALSE(none.standing);
}
