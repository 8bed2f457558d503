// Heat, flow and filler together: no mass or energy is lost when metal melts, moves, is fed and freezes.
#include "core/metal/physical_metal.hpp"
#include "core/weld/process/filler.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;

/// Returns a steel plate of 24 x 20 mm, 6 mm thick, its top at y = 0, insulated, its rim clamped.
PhysicalSetup plate() {
    PhysicalSetup setup;
    setup.material = shippedMaterial("s235");
    setup.lattice = MetalLattice::covering(glm::vec3(-12, -8, -12) * kMm, glm::vec3(12, 8, 12) * kMm, kMm);
    setup.seeds = latticeSeeds(setup.lattice, glm::vec3(-12, -6, -10) * kMm, glm::vec3(12, 0, 10) * kMm, 293.15F);
    for (MetalSeed& seed : setup.seeds)
        if (std::abs(seed.position.x) > 11 * kMm || std::abs(seed.position.z) > 9 * kMm) seed.phase |= PHASE_CLAMPED;
    setup.fillerRoom = 200;
    setup.space = {glm::vec3(-12, -8, -12) * kMm, glm::vec3(12, 8, 12) * kMm};
    setup.fragments.floorHeight = -8 * kMm;
    setup.heat.ledger = true;
    return setup;
}

HeatSource arc() {
    return HeatSource::gaussian(glm::vec3(0), glm::vec3(0, -1, 0), 2 * kMm, 2500);
}

double enthalpyOf(const PhysicalMetal& metal, float temperature) {
    return metal.table().enthalpyAt(static_cast<double>(temperature)) * metal.state().particleMass();
}

bool allFinite(const PhysicalMetal& metal) {
    for (const vec4& place : metal.state().position.read<vec4>(metal.state().particles()))
        if (!std::isfinite(place.x + place.y + place.z + place.w)) return false;
    return true;
}

} // namespace

TEST_CASE("an arc's pool takes exactly the arc's energy, flows, is fed and freezes again", "[physical]") {
    test::context();
    PhysicalMetal metal(test::shaders(), plate());
    const double before = metal.state().readEnergy();
    Filler filler(kMm);
    const std::vector<HeatSource> burning{arc()};
    double fed = 0;
    unsigned mostMoving = 0;
    for (int frame = 0; frame < 100; ++frame) {
        const auto drops = filler.feed(0.405e-9, glm::vec3(0, 4, 0) * kMm, glm::vec3(0, -0.3F, 0), 2200);
        fed += static_cast<double>(drops.size()) * enthalpyOf(metal, 2200);
        metal.step(burning, drops, nullptr);
        if (frame % 20 == 19) mostMoving = std::max(mostMoving, metal.flow().readMoving());
    }
    const double arcEnergy = 2500 * 100 * static_cast<double>(metal.timeStep());
    const double gained = metal.state().readEnergy() - before - fed;
    CHECK(mostMoving > 60);
    CHECK(gained == Approx(arcEnergy).epsilon(1e-4));
    CHECK(filler.fed() == 40);
    CHECK_FALSE(metal.flow().readFaults().any());
    for (int frame = 0; frame < 150; ++frame)
        metal.step({}, {}, nullptr);
    const double after = metal.state().readEnergy() - before - fed;
    CHECK(after == Approx(gained).epsilon(1e-4));
    CHECK(allFinite(metal));
    CHECK(metal.statistics().particles == plate().seeds.size() + 40);
    CHECK(metal.flow().readMoving() < mostMoving / 2);
}

TEST_CASE("a folded state holds no temperatures of its own and is unfolded to the bit", "[physical]") {
    test::context();
    PhysicalMetal metal(test::shaders(), plate()), twin(test::shaders(), plate());
    Filler filler(kMm), twinFiller(kMm);
    const auto weld = [](PhysicalMetal& each, Filler& wire) {
        const std::vector<HeatSource> burning{arc()};
        for (int frame = 0; frame < 40; ++frame)
            each.step(burning, wire.feed(0.405e-9, glm::vec3(0, 4, 0) * kMm, glm::vec3(0, -0.3F, 0), 2200), nullptr);
    };
    const auto places = [&] { return metal.state().position.read<vec4>(metal.state().particles()); };
    weld(metal, filler);
    weld(twin, twinFiller);
    REQUIRE(metal.flow().readMoving() > 20);
    const std::uint64_t before = metal.stateHash();
    REQUIRE(twin.stateHash() == before);
    const auto unfolded = places();
    REQUIRE(std::all_of(unfolded.begin(), unfolded.end(), [](const vec4& place) { return place.w > 290; }));

    metal.xorOutDerivedState();
    const auto folded = places();
    CHECK(metal.stateHash() != before);
    CHECK(std::count_if(folded.begin(), folded.end(), [](const vec4& place) { return place.w == 0; }) ==
          std::ptrdiff_t(folded.size()));
    metal.xorOutDerivedState();
    CHECK(metal.stateHash() == before);
    weld(metal, filler);
    weld(twin, twinFiller);
    CHECK(metal.stateHash() == twin.stateHash());
}

TEST_CASE("wire that is fed outside the space or beyond the most particles is refused and counted", "[physical]") {
    test::context();
    PhysicalSetup setup = plate();
    setup.fillerRoom = 50;
    setup.mostParticles = setup.seeds.size() + 200;
    PhysicalMetal metal(test::shaders(), setup);
    const size_t before = metal.state().particles();
    const std::vector<MetalSeed> drops{{glm::vec3(0, 4, 0) * kMm, 2200, PHASE_ALIVE | PHASE_LIQUID, {}},
                                       {glm::vec3(0, 4, 1000) * kMm, 2200, PHASE_ALIVE | PHASE_LIQUID, {}},
                                       {glm::vec3(0, 9, 0) * kMm, 2200, PHASE_ALIVE | PHASE_LIQUID, {}}};
    metal.step({}, drops, nullptr);
    CHECK(metal.state().particles() == before + 1);
    CHECK(metal.refusedFiller() == 2);
    CHECK(metal.statistics().lost == 2);
    for (int i = 0; i < 70; ++i) // three drops a step
        metal.step({}, std::vector<MetalSeed>(3, drops[0]), nullptr);
    CHECK(metal.state().particles() == before + 200);
    CHECK(metal.refusedFiller() == 2 + 11);
    metal.reset();
    CHECK(metal.statistics().lost == 0);
    // A drop that leaves the wire's end a little above the space falls into it.
    MetalSeed above = drops[2];
    above.velocity = {0, -0.3F, 0};
    metal.step({}, std::vector{above}, nullptr);
    CHECK(metal.refusedFiller() == 0);
    CHECK(metal.state().particles() == before + 1);
}

TEST_CASE("two welds alike give the same bits", "[physical]") {
    test::context();
    PhysicalMetal metal(test::shaders(), plate());
    std::uint64_t hashes[2];
    for (std::uint64_t& hash : hashes) {
        Filler filler(kMm);
        for (int frame = 0; frame < 40; ++frame)
            metal.step(std::vector<HeatSource>{arc()},
                       filler.feed(0.405e-9, glm::vec3(0, 4, 0) * kMm, glm::vec3(0, -0.3F, 0), 2200), nullptr);
        hash = metal.stateHash();
        metal.reset();
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("a block that lies loose on a plate is part of it once metal has frozen between them", "[physical]") {
    test::context();
    PhysicalSetup setup = plate();
    setup.heat.convection = 2e4; // freezes quickly
    const auto block = latticeSeeds(setup.lattice, glm::vec3(-3, 1, -3) * kMm, glm::vec3(3, 3, 3) * kMm, 293.15F);
    setup.seeds.insert(setup.seeds.end(), block.begin(), block.end());
    PhysicalMetal metal(test::shaders(), setup);
    const auto run = [&](int frames, float power) {
        const std::vector<HeatSource> sources{HeatSource::sphere(glm::vec3(4, 0.5F, 0) * kMm, 4 * kMm, power)};
        for (int frame = 0; frame < frames; ++frame)
            metal.step(std::span(sources).first(power > 0 ? 1 : 0), {}, nullptr);
    };
    run(60, 0);
    CHECK(metal.fragments().report().particles == block.size()); // it has fallen by a spacing and is at rest
    run(25, 6000);
    CHECK(metal.flow().readMoving() > block.size());
    CHECK(metal.fragments().report().particles > 0); // its other end is still solid
    run(120, 0);
    CHECK(metal.statistics().molten == 0);
    CHECK(metal.fragments().report().fragments == 0);
    CHECK_FALSE(metal.flow().readFaults().any());
}

TEST_CASE("a time step is made to fit one step of heat where two would hardly be needed", "[physical]") {
    test::context();
    const PhysicalMetal steel(test::shaders(), plate());
    const auto step = static_cast<double>(steel.timeStep());
    CHECK(step < 1.0 / 90);
    CHECK(step > 0.8 / 90);
    CHECK(step <= steel.heat().longestStep(3500));
    PhysicalSetup stainless = plate();
    stainless.material = shippedMaterial("304"); // poor conduction: a whole frame makes no difference
    CHECK(PhysicalMetal(test::shaders(), stainless).timeStep() == 1.0F / 90);
    stainless.material = shippedMaterial("copper"); // needs many heat steps anyway
    CHECK(PhysicalMetal(test::shaders(), stainless).timeStep() == 1.0F / 90);
}

} // namespace meltpool
