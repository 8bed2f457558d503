// Freezing times of particles: preserved from melting to melting and through saved states.
#include "core/gl/state_archive.hpp"
#include "core/validation/heat_rig.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstddef>
#include <random>
#include <vector>

using namespace meltpool;

namespace {

constexpr float kSpacing = 1e-3F;

Material simpleSteel() {
    Material m;
    m.solidus = 1700;
    m.liquidus = 1800;
    m.latentHeat = 2.7e5;
    m.solidDensity = m.liquidDensity = Property::constant(7000);
    m.solidConductivity = m.liquidConductivity = Property::constant(30);
    m.solidSpecificHeat = m.liquidSpecificHeat = Property::constant(700);
    m.emissivity = Property::constant(0.7);
    return m;
}

/// Cold metal with hot spots in it, and a drop on it.
std::vector<MetalSeed> hotSpots(const MetalLattice& lattice, glm::vec3 low, glm::vec3 high) {
    auto seeds = latticeSeeds(lattice, low, high, 900);
    std::mt19937 random(7);
    for (MetalSeed& seed : seeds)
        if (random() % 6 == 0) seed.temperature = 2900;
    seeds.push_back({{0.006F, high.y + kSpacing / 2, 0.006F}, 1900, PHASE_ALIVE | PHASE_LIQUID, glm::vec3(0)});
    return seeds;
}

} // namespace

TEST_CASE("metal keeps the time at which it froze, molten metal and what never melted have none", "[heat]") {
    const bool leaves = GENERATE(true, false);
    const glm::vec3 low(2 * kSpacing), high(0.012F, 0.010F, 0.011F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high + 3 * kSpacing, kSpacing);
    HeatSettings settings;
    settings.meltedLeaves = leaves;
    HeatRig bench(test::shaders(), lattice, simpleSteel(), hotSpots(lattice, low, high), settings);
    const size_t count = bench.state.particles();
    std::vector<float> expected(count, 0);
    expected.back() = METAL_MOLTEN;
    CHECK(bench.state.frozenAt.read<float>(count) == expected);
    const auto wasLiquid = [&](size_t i) { return expected[i] == METAL_MOLTEN; };
    const double step = bench.solver.longestStep(3000);
    double time = 0;
    size_t froze = 0, molten = 0;
    for (int i = 0; i < 60; ++i) {
        bench.solver.step(step, {});
        time += step;
        const auto phases = bench.state.phase.read<uint>(count);
        for (size_t slot = 0; slot < count; ++slot) {
            const bool liquid = (phases[slot] & PHASE_LIQUID) != 0;
            if (!liquid && wasLiquid(slot)) {
                expected[slot] = static_cast<float>(time);
                ++froze;
            }
            if (liquid) expected[slot] = METAL_MOLTEN;
            molten += liquid;
        }
        REQUIRE(bench.state.frozenAt.read<float>(count) == expected);
    }
    CHECK(froze > 50);
    CHECK(molten > 50);

    gl::StateCapture capture;
    gl::StateArchive saving(capture.begin());
    bench.state.transfer(saving);
    capture.request();
    capture.wait();
    std::vector<std::byte> bytes;
    std::vector<gl::StatePart> parts;
    capture.assemble(bytes, parts);
    bench.state.reset();
    bench.state.add(hotSpots(lattice, low, high));
    REQUIRE(bench.state.frozenAt.read<float>(count) != expected);
    gl::StateArchive restoring{std::span<const std::byte>(bytes)};
    bench.state.transfer(restoring);
    CHECK(bench.state.frozenAt.read<float>(count) == expected);
}
