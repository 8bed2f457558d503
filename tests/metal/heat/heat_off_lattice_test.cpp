// Heat in metal off the lattice: no energy is lost, and conduction equals that of the lattice.
#include "core/validation/exact_solutions.hpp"
#include "core/validation/heat_rig.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace meltpool;

namespace {

constexpr float kSpacing = 1e-3F;

Material simpleMetal() {
    Material m;
    m.solidus = m.liquidus = 3000;
    m.latentHeat = 2.7e5;
    m.solidDensity = m.liquidDensity = Property::constant(7000);
    m.solidConductivity = m.liquidConductivity = Property::constant(30);
    m.solidSpecificHeat = m.liquidSpecificHeat = Property::constant(30 / (7000 * 6e-6));
    m.emissivity = Property::constant(0.5);
    return m;
}

/// Takes seeds off the lattice and shakes each by up to `shake` spacings along every axis.
void takeOffLattice(std::vector<MetalSeed>& seeds, float from, float shake) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> offset(-shake * kSpacing, shake * kSpacing);
    for (MetalSeed& seed : seeds) {
        if (seed.position.x < from || (seed.phase & PHASE_HELD)) continue;
        seed.phase &= ~PHASE_LATTICE;
        seed.position += glm::vec3(offset(random), offset(random), offset(random));
    }
}

} // namespace

TEST_CASE("Metal off the lattice keeps every joule", "[heat][off-lattice]") {
    const Material m = simpleMetal();
    const glm::vec3 low(2 * kSpacing), high(0.014F, 0.01F, 0.012F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high + 3 * kSpacing, kSpacing);
    auto seeds = latticeSeeds(lattice, low, high, 300);
    std::mt19937 random(5);
    for (MetalSeed& seed : seeds)
        seed.temperature = 300 + static_cast<float>(random() % 3000);
    takeOffLattice(seeds, 0.007F, 0.4F);
    HeatSettings settings;
    settings.ledger = true;
    const bool loses = GENERATE(false, true);
    settings.convection = loses ? 200 : 0;
    settings.radiation = loses;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    const double before = bench.state.readEnergy();
    const auto source = HeatSource::gaussian({0.008F, high.y, 0.007F}, {0, -1, 0}, 2 * kSpacing, 500);
    for (int i = 0; i < 200; ++i)
        bench.solver.step(5e-3, std::vector{source});
    const HeatBalance balance = bench.solver.readBalance();
    CHECK(balance.gained == Approx(500).epsilon(1e-6));
    CHECK((balance.lost > 0) == loses);
    const double change = bench.state.readEnergy() - before;
    CHECK(std::abs(change - balance.gained + balance.lost) < 1e-5 * balance.gained);
}

TEST_CASE("No metal gets colder than the coldest or hotter than the hottest was", "[heat][off-lattice]") {
    const Material m = simpleMetal();
    const glm::vec3 low(2 * kSpacing), high(0.01F, 0.01F, 0.01F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high + 3 * kSpacing, kSpacing);
    auto seeds = latticeSeeds(lattice, low, high, 293);
    const bool hotDrops = GENERATE(true, false);
    for (MetalSeed& seed : seeds)
        seed.temperature = hotDrops ? 293 : 2500;
    takeOffLattice(seeds, 0.007F, 0.4F);
    // Drops buried in the metal, such as a burning wire leaves.
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(low.x, high.x);
    for (int i = 0; i < 40; ++i)
        seeds.push_back({{place(random), place(random), place(random)}, hotDrops ? 2500.0F : 293.0F, PHASE_ALIVE, {}});
    for (int i = 0; i < 20; ++i)
        seeds.push_back({{0.0051F, 0.0052F, 0.0053F}, hotDrops ? 2500.0F : 293.0F, PHASE_ALIVE, {}});
    HeatRig bench(test::shaders(), lattice, m, seeds, HeatSettings{});
    const double before = bench.state.readEnergy();
    double coldest = 1e9, hottest = 0;
    for (int i = 0; i < 60; ++i) {
        bench.solver.step(bench.solver.longestStep(2500), {});
        for (const double t : bench.readTemperatures()) {
            coldest = std::min(coldest, t);
            hottest = std::max(hottest, t);
        }
    }
    CHECK(coldest > 293 - 0.05);
    CHECK(hottest < 2500 + 0.05);
    CHECK(bench.state.readEnergy() == Approx(before).epsilon(1e-5));
}

TEST_CASE("Metal off the lattice conducts as metal on it does", "[heat][off-lattice]") {
    const Material m = simpleMetal();
    // A long bar has a hot end; part or all of it is shaken off the lattice.
    const float depth = 0.032F;
    const float side = 8 * kSpacing;
    const MetalLattice lattice = MetalLattice::covering({-kSpacing, 0, 0}, {depth, side, side}, kSpacing);
    auto seeds = latticeSeeds(lattice, {-kSpacing, 0, 0}, {depth, side, side}, 293);
    for (MetalSeed& seed : seeds)
        if (seed.position.x < 0) {
            seed.phase |= PHASE_HELD;
            seed.temperature = 1500;
        }
    const float shake = GENERATE(0.0F, 0.3F);
    const float from = GENERATE(0.0F, 0.004F);
    takeOffLattice(seeds, from, shake);
    for (MetalSeed& seed : seeds)
        seed.position = glm::clamp(seed.position, glm::vec3(-1), glm::vec3(1, side, side));
    HeatSettings settings;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    bench.run(0, 4, 1500, nothingBurns);
    double squares = 0, most = 0;
    size_t count = 0;
    for (const vec4& p : bench.state.position.read<vec4>(seeds.size())) {
        const auto x = static_cast<double>(p.x);
        // Side faces are excluded, where a shaken column is thinner than a full one.
        if (x < 0 || x > 0.015 || p.y < 2 * kSpacing || p.y > 6 * kSpacing || p.z < 2 * kSpacing || p.z > 6 * kSpacing)
            continue;
        const double error = static_cast<double>(p.w) - exact::conductionStep(293, 1500, 6e-6, x, 4);
        squares += error * error;
        most = std::max(most, std::abs(error));
        ++count;
    }
    const double rms = std::sqrt(squares / static_cast<double>(count)) / 1207;
    INFO("shake " << shake << " from " << from << ": rms " << rms << " max " << most / 1207);
    CHECK(rms < 0.015);
    CHECK(most / 1207 < 0.05);
}

TEST_CASE("Stirred liquid conducts less along the axes that its stirring does not lead", "[heat][off-lattice]") {
    Material m = simpleMetal();
    const bool molten = GENERATE(true, false);
    m.solidus = m.liquidus = molten ? 400 : 3000;
    const glm::vec3 low(2 * kSpacing), size(0.016F, 0.016F, 0.016F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), low + size + 2 * kSpacing, kSpacing);
    // A half wave along one axis between insulated ends falls as exp(-alpha (pi/L)² t).
    const int axis = GENERATE(0, 1, 2);
    const auto wave = [&](vec3 place) {
        return std::cos(std::numbers::pi * double((place[axis] - low[axis]) / size[axis]));
    };
    auto seeds = latticeSeeds(lattice, low, low + size, 300);
    for (MetalSeed& seed : seeds)
        seed.temperature = static_cast<float>(1500 + 500 * wave(seed.position));
    takeOffLattice(seeds, 0, 0);
    HeatSettings settings;
    settings.directedMixing = true;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    bench.solver.setStirringLess({0, 0.75F, 0.4F});
    const double before = bench.state.readEnergy();
    for (int i = 0; i < 200; ++i)
        bench.solver.step(0.02, {});
    const std::array<double, 3> shares{1, molten ? 0.25 : 1, molten ? 0.6 : 1};
    double sum = 0, squares = 0;
    for (const vec4& p : bench.state.position.read<vec4>(seeds.size())) {
        sum += (double(p.w) - 1500) * wave(vec3(p));
        squares += wave(vec3(p)) * wave(vec3(p));
    }
    const double length = double(size[axis]);
    const double rate = shares[static_cast<size_t>(axis)] * 6e-6 * std::pow(std::numbers::pi / length, 2);
    INFO("axis " << axis);
    CHECK(sum / squares == Approx(500 * std::exp(-rate * 4)).epsilon(0.005));
    CHECK(bench.state.readEnergy() == Approx(before).epsilon(1e-6));
}

TEST_CASE("Nothing flows between a held wall and led liquid of its temperature", "[heat][off-lattice]") {
    Material m = simpleMetal();
    m.solidus = m.liquidus = 400;
    const float side = 8 * kSpacing;
    const MetalLattice lattice = MetalLattice::covering({-kSpacing, 0, 0}, {side, side, side}, kSpacing);
    auto seeds = latticeSeeds(lattice, {-kSpacing, 0, 0}, {side, side, side}, 1500);
    for (MetalSeed& seed : seeds)
        if (seed.position.x < 0) seed.phase |= PHASE_HELD;
    takeOffLattice(seeds, 0, 0);
    HeatSettings settings;
    settings.directedMixing = true;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    bench.solver.setStirringLess({0.75F, 0, 0});
    for (int i = 0; i < 50; ++i)
        bench.solver.step(0.02, {});
    for (const double t : bench.readTemperatures())
        REQUIRE(t == Approx(1500).margin(0.05));
}

TEST_CASE("A free fragment conducts where it touches and not where it does not", "[heat][off-lattice]") {
    const Material m = simpleMetal();
    const float side = 8 * kSpacing;
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), {side, 0.016F, side}, kSpacing);
    auto seeds = latticeSeeds(lattice, glm::vec3(0), {side, 4 * kSpacing, side}, 300);
    auto block = latticeSeeds(lattice, {0, 4 * kSpacing, 0}, {side, 8 * kSpacing, side}, 1300);
    const float gap = GENERATE(0.0F, 2.1F);
    for (MetalSeed& seed : block) {
        seed.phase &= ~PHASE_LATTICE;
        seed.position.y += gap * kSpacing;
    }
    const size_t below = seeds.size();
    seeds.insert(seeds.end(), block.begin(), block.end());
    HeatRig bench(test::shaders(), lattice, m, seeds, HeatSettings{});
    bench.run(0, 30, 1500, nothingBurns);
    double mean = 0;
    const auto temperatures = bench.readTemperatures();
    for (size_t i = 0; i < below; ++i)
        mean += temperatures[i] / static_cast<double>(below);
    CHECK(mean == Approx(gap > 0 ? 300 : 800).margin(2));
}

TEST_CASE("Metal taken off the lattice by others is found, and its old cell is free", "[heat][off-lattice]") {
    const Material m = simpleMetal();
    const float side = 4 * kSpacing;
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), {side, 3 * side, side}, kSpacing);
    auto seeds = latticeSeeds(lattice, glm::vec3(0), glm::vec3(side), 300);
    HeatSettings settings;
    settings.ledger = true;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    bench.solver.step(1e-3, {});
    // The upper half is a tile higher, as a free fragment would be.
    auto positions = bench.state.position.read<vec4>(seeds.size());
    auto phases = bench.state.phase.read<uint>(seeds.size());
    auto cells = bench.state.latticeSlots.read<uint>(lattice.cellCount());
    for (size_t i = 0; i < seeds.size(); ++i) {
        if (positions[i].y < 2 * kSpacing) continue;
        cells[lattice.index(lattice.cellAt(glm::vec3(positions[i])))] = 0;
        positions[i].y += side;
        phases[i] &= ~PHASE_LATTICE;
    }
    bench.state.position.write(std::span<const vec4>(positions));
    bench.state.phase.write(std::span<const uint>(phases));
    bench.state.latticeSlots.write(std::span<const uint>(cells));
    bench.state.noteRegrouping();
    const double before = bench.state.readEnergy();
    const auto source = HeatSource::gaussian({side / 2, 2 * kSpacing, side / 2}, {0, -1, 0}, 2 * kSpacing, 50);
    bench.run(0, 2, 2000, [&](double) { return std::vector{source}; });
    CHECK(bench.state.readEnergy() - before == Approx(100).epsilon(1e-5));
    // The arc reaches the surfaces of both halves.
    const auto temperatures = bench.readTemperatures();
    CHECK(temperatures.front() > 320);
    CHECK(temperatures.back() > 320);
}

TEST_CASE("Other passes find every slot off the lattice in the solver's list", "[heat][off-lattice]") {
    const Material m = simpleMetal();
    const glm::vec3 high(0.008F, 0.008F, 0.008F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high, kSpacing);
    auto seeds = latticeSeeds(lattice, glm::vec3(0), high, 300);
    takeOffLattice(seeds, 0.005F, 0.4F);
    HeatSettings settings;
    settings.meltedLeaves = true;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    const OffLatticeList list = bench.solver.offLattice();
    const auto listed = [&] {
        const auto count = list.control.read<uint>(1, list.count)[0];
        CHECK(list.control.read<uint>(1, list.dispatch)[0] == (count + GROUP_SIZE - 1) / GROUP_SIZE);
        auto slots = list.slots.read<uint>(count, list.first * sizeof(uint));
        std::sort(slots.begin(), slots.end());
        return slots;
    };
    const auto offLattice = [&] {
        std::vector<uint> slots;
        const auto phases = bench.state.phase.read<uint>(bench.state.particles());
        for (uint slot = 0; slot < phases.size(); ++slot)
            if (!(phases[slot] & PHASE_LATTICE)) slots.push_back(slot);
        return slots;
    };
    CHECK(listed().empty());
    bench.solver.step(1e-3, {});
    CHECK(listed() == offLattice());
    const size_t before = listed().size();
    const auto hot = HeatSource::sphere({0.002F, 0.002F, 0.002F}, 2 * kSpacing, 20000);
    for (int i = 0; i < 20; ++i)
        bench.solver.step(1e-3, std::vector{hot});
    CHECK(listed().size() > before); // some have melted
    CHECK(listed() == offLattice());
}

TEST_CASE("Metal off the lattice gives the same bits twice", "[heat][off-lattice]") {
    const Material m = simpleMetal();
    const glm::vec3 high(0.012F, 0.008F, 0.012F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high, kSpacing);
    const auto run = [&] {
        auto seeds = latticeSeeds(lattice, glm::vec3(0), high, 300);
        takeOffLattice(seeds, 0.005F, 0.4F);
        HeatSettings settings;
        settings.convection = 20;
        HeatRig bench(test::shaders(), lattice, m, seeds, settings);
        const auto source = HeatSource::gaussian({0.006F, high.y, 0.006F}, {0, -1, 0}, 2 * kSpacing, 2000);
        for (int i = 0; i < 50; ++i)
            bench.solver.step(4e-3, std::vector{source});
        return bench.state.heat.read<vec4>(bench.state.particles());
    };
    CHECK(run() == run());
}

TEST_CASE("Metal that lies on the welding table cools as one lump does, metal above it does not",
          "[heat][off-lattice]") {
    const Material m = simpleMetal();
    const glm::vec3 low(2 * kSpacing), high(0.006F, 0.003F, 0.006F); // a single layer
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high + 6 * kSpacing, kSpacing);
    auto seeds = latticeSeeds(lattice, low, high, 900);
    takeOffLattice(seeds, 0, 0);
    HeatSettings settings;
    settings.ambient = 300;
    settings.tableConductance = 2000;
    const bool lies = GENERATE(true, false);
    settings.tableHeight = lies ? 0.002 : 0.0005;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    constexpr double kSeconds = 1;
    for (int i = 0; i < 200; ++i)
        bench.solver.step(kSeconds / 200, {});
    const double heatCapacity = 7000 * m.solidSpecificHeat.at(900) * static_cast<double>(kSpacing);
    const double expected = lies ? 300 + 600 * std::exp(-2000 * kSeconds / heatCapacity) : 900;
    for (const vec4& p : bench.state.position.read<vec4>(seeds.size()))
        CHECK(static_cast<double>(p.w) == Approx(expected).epsilon(0.01));
}
