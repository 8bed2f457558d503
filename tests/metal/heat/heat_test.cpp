// The heat passes against a twin on the CPU, and the laws of every step: energy, determinism, memory of the peak.
#include "core/base/error.hpp"
#include "core/metal/heat/heat.hpp"
#include "core/validation/heat_rig.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace meltpool;

namespace {

Material steelLike() {
    Material m;
    m.solidus = 1700;
    m.liquidus = 1800;
    m.latentHeat = 2.7e5;
    m.solidDensity = m.liquidDensity = Property::constant(7000);
    m.solidConductivity = {{{300, 50}, {1200, 25}}, "test"};
    m.liquidConductivity = Property::constant(40);
    m.solidSpecificHeat = {{{300, 450}, {1200, 700}}, "test"};
    m.liquidSpecificHeat = Property::constant(800);
    m.emissivity = Property::constant(0.7);
    return m;
}

/// A block of cells on a lattice with room around it, at temperatures that differ from cell to cell.
std::vector<MetalSeed> unevenBlock(const MetalLattice& lattice, glm::vec3 low, glm::vec3 high) {
    auto seeds = latticeSeeds(lattice, low, high, 300);
    std::mt19937 random(7);
    for (MetalSeed& seed : seeds)
        seed.temperature = 300 + static_cast<float>(random() % 2200);
    return seeds;
}

/// Returns the power that a cell takes up from the squares of its four neighbours, W: a sixth of each square's twist.
/// `thetas` is -1 in empty cells.
double squarePower(const MetalLattice& lattice, const std::vector<double>& thetas, glm::ivec3 cell) {
    const auto thetaAt = [&](glm::ivec3 at) { return lattice.contains(at) ? thetas[lattice.index(at)] : -1; };
    double twist = 0;
    for (int first = 0; first < 3; ++first)
        for (int second = first + 1; second < 3; ++second)
            for (int corner = 0; corner < 4; ++corner) {
                glm::ivec3 one(0), other(0);
                one[first] = corner % 2 == 0 ? -1 : 1;
                other[second] = corner / 2 == 0 ? -1 : 1;
                const double a = thetaAt(cell + one), b = thetaAt(cell + other), c = thetaAt(cell + one + other);
                if (a >= 0 && b >= 0 && c >= 0) twist += thetaAt(cell) - a - b + c;
            }
    return static_cast<double>(lattice.spacing) * twist / 6;
}

/// Makes one explicit step in double precision, directly from the definition.
std::vector<double> twinStep(const MetalLattice& lattice, const std::vector<MetalSeed>& seeds, const HeatTable& table,
                             const Material& m, double mass, const HeatSettings& settings, const HeatSource& source,
                             double dt) {
    std::vector<int> at(lattice.cellCount(), -1);
    for (size_t i = 0; i < seeds.size(); ++i)
        at[lattice.index(lattice.cellAt(seeds[i].position))] = static_cast<int>(i);
    const auto h = static_cast<double>(lattice.spacing);
    const glm::ivec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::vector<double> enthalpy, power(seeds.size(), 0), weight(seeds.size(), 0);
    for (const MetalSeed& seed : seeds)
        enthalpy.push_back(table.enthalpyAt(static_cast<double>(seed.temperature)));
    std::vector<double> thetas(lattice.cellCount(), -1);
    for (size_t i = 0; i < seeds.size(); ++i)
        thetas[lattice.index(lattice.cellAt(seeds[i].position))] = table.kirchhoffAt(enthalpy[i]);
    double total = 0;
    for (size_t i = 0; i < seeds.size(); ++i) {
        const glm::ivec3 cell = lattice.cellAt(seeds[i].position);
        power[i] += squarePower(lattice, thetas, cell);
        glm::dvec3 normal(0), open(0);
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                const glm::ivec3 other = cell + side * axes[axis];
                const int j = lattice.contains(other) ? at[lattice.index(other)] : -1;
                if (j < 0) {
                    normal[axis] += side;
                    open[axis] += 1;
                } else {
                    power[i] +=
                        h * (table.kirchhoffAt(enthalpy[static_cast<size_t>(j)]) - table.kirchhoffAt(enthalpy[i]));
                }
            }
        const double area = glm::length(open) * h * h;
        const auto t = static_cast<double>(seeds[i].temperature);
        power[i] -= area * settings.convection * (t - settings.ambient);
        if (settings.radiation)
            power[i] -= area * m.emissivity.at(0) * 5.670374e-8 * (std::pow(t, 4) - std::pow(settings.ambient, 4));
        const glm::dvec3 d = glm::dvec3(seeds[i].position) - glm::dvec3(source.position);
        const glm::dvec3 axis(source.axis);
        const double depth = glm::dot(d, axis);
        const double size = glm::length(normal);
        const double facing = size > 0 ? std::max(0.0, -glm::dot(normal / size, axis)) : 0;
        weight[i] = area * facing * std::exp(-(glm::dot(d, d) - depth * depth) / (2 * std::pow(source.size, 2)));
        total += weight[i];
    }
    for (size_t i = 0; i < seeds.size(); ++i) {
        power[i] += static_cast<double>(source.power) * weight[i] / total;
        enthalpy[i] += power[i] * dt / mass;
    }
    return enthalpy;
}

} // namespace

TEST_CASE("One step on the lattice equals its twin on the CPU", "[heat]") {
    const Material m = steelLike();
    const HeatTable table(m);
    const float h = 1e-3F;
    const auto size = GENERATE(glm::ivec3(1, 1, 1), glm::ivec3(3, 5, 2), glm::ivec3(9, 7, 11), glm::ivec3(16, 4, 8));
    const glm::vec3 low(2 * h, h, 3 * h);
    const glm::vec3 high = low + glm::vec3(size) * h;
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high, h);
    auto seeds = unevenBlock(lattice, low, high);
    REQUIRE(seeds.size() == static_cast<size_t>(size.x * size.y * size.z));
    if (GENERATE(false, true)) { // holes leave some squares without a cell
        std::mt19937 random(11);
        std::erase_if(seeds, [&](const MetalSeed&) { return random() % 6 == 0; });
    }
    HeatSettings settings;
    settings.convection = 40;
    settings.radiation = true;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    const glm::vec3 spot(0.5F * (low.x + high.x), high.y, 0.5F * (low.z + high.z));
    // Tiles in reach of a source are mixed, the others plain.
    const float power = GENERATE(500.0F, 0.0F);
    const auto source = HeatSource::gaussian(spot, {0, -1, 0}, 2 * h, power);
    const double dt = 2e-3;
    bench.solver.step(dt, power > 0 ? std::vector{source} : std::vector<HeatSource>{});
    const auto expected = twinStep(lattice, seeds, table, m, bench.state.particleMass(), settings, source, dt);
    const auto heats = bench.state.heat.read<vec4>(seeds.size());
    double worst = 0;
    for (size_t i = 0; i < seeds.size(); ++i) {
        const double start = table.enthalpyAt(static_cast<double>(seeds[i].temperature));
        const double ours = static_cast<double>(heats[i].x) + static_cast<double>(heats[i].y);
        worst =
            std::max(worst, std::abs((ours - start) - (expected[i] - start)) / (std::abs(expected[i] - start) + 300));
    }
    CHECK(worst < 2e-3); // the sampled table's error on changes of tens of kJ/kg
}

TEST_CASE("A source gives exactly its power, whatever metal is there", "[heat]") {
    const Material m = steelLike();
    const float h = 1e-3F;
    const glm::vec3 high(0.02F, 0.006F, 0.02F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high, h);
    const auto seeds = latticeSeeds(lattice, glm::vec3(0), high, 300);
    HeatSettings settings;
    settings.ledger = true;
    const glm::vec3 corner(0, high.y, 0); // half of every source is beyond the edge
    const std::vector<HeatSource> sources{
        HeatSource::sphere(corner, 0.004F, 100), HeatSource::gaussian(corner, {0, -1, 0}, 2 * h, 200),
        HeatSource::ellipsoid(corner, {0, -1, 0}, {1, 0, 0}, 3 * h, 2 * h, 3 * h, 6 * h, 0.6F, 400)};
    for (size_t i = 0; i < sources.size(); ++i) {
        HeatRig bench(test::shaders(), lattice, m, seeds, settings);
        const double before = bench.state.readEnergy();
        for (int step = 0; step < 20; ++step)
            bench.solver.step(1e-3, std::span(sources).subspan(i, 1));
        const double put = static_cast<double>(sources[i].power) * 0.02;
        CHECK(bench.solver.readBalance().gained == Approx(put).epsilon(1e-6));
        CHECK(bench.state.readEnergy() - before == Approx(put).epsilon(1e-6));
    }
    SECTION("all at once") {
        HeatRig bench(test::shaders(), lattice, m, seeds, settings);
        bench.solver.step(1e-3, sources);
        CHECK(bench.solver.readBalance().gained == Approx(0.7).epsilon(1e-6));
    }
    SECTION("nothing where no metal is") {
        HeatRig bench(test::shaders(), lattice, m, seeds, settings);
        bench.solver.step(1e-3, std::vector{HeatSource::sphere({0.5F, 0.5F, 0.5F}, 0.004F, 100)});
        CHECK(bench.solver.readBalance().gained == 0);
    }
    SECTION("too many at once are refused") {
        HeatRig bench(test::shaders(), lattice, m, seeds, settings);
        const std::vector<HeatSource> many(HEAT_SOURCES + 1, sources[0]);
        CHECK_THROWS_AS(bench.solver.step(1e-3, many), RuntimeFault);
    }
}

TEST_CASE("A hot tip gives what its contact lets through, and at most its power", "[heat]") {
    const Material m = steelLike();
    const float h = 1e-3F;
    const glm::vec3 high(0.02F, 0.004F, 0.02F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high, h);
    const auto seeds = latticeSeeds(lattice, glm::vec3(0), high, 300);
    HeatSettings settings;
    settings.ledger = true;
    const auto gained = [&](float power) {
        HeatRig bench(test::shaders(), lattice, m, seeds, settings);
        const auto tip = HeatSource::hotTip({0.01F, high.y, 0.01F}, 1.2F * h, 700, 2000, power);
        bench.solver.step(1e-3, std::vector{tip});
        return bench.solver.readBalance().gained;
    };
    // Four cells of 1 mm² are within 1.2 mm of their common corner.
    CHECK(gained(1000) == Approx(4e-6 * 2000 * 400 * 1e-3).epsilon(1e-4));
    CHECK(gained(1) == Approx(1e-3).epsilon(1e-5));
}

TEST_CASE("Cold tiles rest, and resting costs neither energy nor much accuracy", "[heat]") {
    const Material m = steelLike();
    const float h = 1e-3F;
    const glm::vec3 high(0.08F, 0.004F, 0.04F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high, h);
    const auto seeds = latticeSeeds(lattice, glm::vec3(0), high, 300);
    const auto source = HeatSource::gaussian({0.01F, high.y, 0.01F}, {0, -1, 0}, 2 * h, 800);
    HeatSettings settings;
    settings.ambient = 300;
    settings.ledger = true;
    HeatRig resting(test::shaders(), lattice, m, seeds, settings);
    settings.wakingKelvin = -1; // every tile takes part in every step
    HeatRig awake(test::shaders(), lattice, m, seeds, settings);
    const double dt = resting.solver.longestStep(3000);
    for (int i = 0; i < 100; ++i)
        for (HeatRig* bench : {&resting, &awake})
            bench->solver.step(dt, std::vector{source});
    CHECK(awake.solver.readActiveTiles() == lattice.tileCount());
    CHECK(resting.solver.readActiveTiles() < lattice.tileCount() / 2);
    CHECK(resting.state.readEnergy() == Approx(awake.state.readEnergy()).epsilon(1e-9));
    const auto a = resting.readTemperatures();
    const auto b = awake.readTemperatures();
    double worst = 0;
    for (size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, std::abs(a[i] - b[i]));
    CHECK(worst < 0.15);
}

TEST_CASE("Two runs give the same bits", "[heat]") {
    const Material m = steelLike();
    const float h = 1e-3F;
    const glm::vec3 high(0.03F, 0.005F, 0.03F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high, h);
    const auto run = [&] {
        HeatSettings settings;
        settings.convection = 20;
        settings.radiation = true;
        HeatRig bench(test::shaders(), lattice, m, unevenBlock(lattice, glm::vec3(0), high), settings);
        for (int i = 0; i < 60; ++i) {
            const float x = 0.005F + 2e-4F * static_cast<float>(i);
            bench.solver.step(4e-3, std::vector{HeatSource::gaussian({x, high.y, 0.015F}, {0, -1, 0}, 2 * h, 2000),
                                                HeatSource::sphere({x, 0, 0.01F}, 3 * h, 300)});
        }
        return bench.state.heat.read<vec4>(bench.state.particles());
    };
    CHECK(run() == run());
}

TEST_CASE("A particle remembers its peak and how long it cooled from 800 to 500 degrees", "[heat]") {
    Material m = steelLike();
    m.solidSpecificHeat = Property::constant(600);
    const float h = 1e-3F;
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), glm::vec3(h), h);
    const auto seeds = latticeSeeds(lattice, glm::vec3(0), glm::vec3(h), 1300);
    HeatSettings settings;
    settings.ambient = 300;
    settings.convection = 500;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    bench.run(0, 20, 2000, nothingBurns);
    // One free cell has six open sides, which counts as the length of (2, 2, 2); it cools as exp(-t/tau).
    const double tau = bench.state.particleMass() * 600 / (500 * std::sqrt(12.0) * 1e-6);
    const double expected = tau * std::log((1073.15 - 300) / (773.15 - 300));
    const vec4 heat = bench.state.heat.read<vec4>(1)[0];
    CHECK(heat.z == Approx(1300).margin(0.1));
    CHECK(heat.w == Approx(expected).epsilon(0.02));
    bench.run(0, 1, 2000, [&](double) { return std::vector{HeatSource::sphere(glm::vec3(0), 0.01F, 5)}; });
    CHECK(bench.state.heat.read<vec4>(1)[0].w == 0); // reheating restarts the count
}

TEST_CASE("Melting and freezing wait for their fractions", "[heat]") {
    const Material m = steelLike();
    const HeatTable table(m);
    const float h = 1e-3F;
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), glm::vec3(h), h);
    auto seeds = latticeSeeds(lattice, glm::vec3(0), glm::vec3(h), 1745);
    HeatSettings settings;
    const bool leaves = GENERATE(false, true);
    settings.meltedLeaves = leaves;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    const auto heatBy = [&](double joules) {
        bench.solver.step(1e-3,
                          std::vector{HeatSource::sphere(glm::vec3(0), 0.01F, static_cast<float>(joules / 1e-3))});
        return bench.state.phase.read<uint>(1)[0];
    };
    const double whole = (table.liquidusEnthalpy() - table.solidusEnthalpy()) * bench.state.particleMass();
    CHECK((heatBy(0.1 * whole) & PHASE_LIQUID) == 0); // at 0.55: still immobile
    CHECK(bench.state.changes.read<uint>(1)[0] == 0);
    const uint melted = heatBy(0.1 * whole); // at 0.65: flowing
    CHECK((melted & PHASE_LIQUID) != 0);
    CHECK(bench.state.changes.read<uint>(2) == std::vector<uint>{1, 0}); // one change, of slot 0
    CHECK(((melted & PHASE_LATTICE) == 0) == leaves);
    if (leaves) {
        CHECK(bench.state.latticeSlots.read<uint>(1)[0] == 0);
    } else {
        CHECK((heatBy(-0.1 * whole) & PHASE_LIQUID) != 0); // at 0.55: still flowing
        CHECK((heatBy(-0.3 * whole) & PHASE_LIQUID) == 0); // at 0.25: immobile
    }
}

TEST_CASE("A torch's Gaussian heats what it faces in front of it and what catches it", "[heat]") {
    const Material m = steelLike();
    const float h = 1e-3F;
    const glm::vec3 low(0, 0.01F, 0), high(0.02F, 0.016F, 0.02F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), {high.x, 0.03F, high.z}, h);
    HeatSettings settings;
    settings.ledger = true;
    const auto joules = [&](const HeatSource& source) {
        HeatRig bench(test::shaders(), lattice, m, latticeSeeds(lattice, low, high, 300), settings);
        bench.solver.step(1e-3, std::vector{source});
        return bench.solver.readBalance().gained;
    };
    const glm::vec3 down(0, -1, 0), top(0.01F, high.y, 0.01F), edge(0.02F, high.y, 0.01F);
    const auto at = [&](glm::vec3 place, glm::vec3 axis) { return HeatSource::gaussian(place, axis, 2 * h, 1000); };
    CHECK(joules(at(top, down).inFront(0.01F, 4 * h)) == Approx(1));
    // The place as seen from a torch that has passed it, and from one that a nearer surface shields.
    CHECK(joules(at(top - glm::vec3(0, 0.012F, 0), down).inFront(0, 0.04F)) == 0);
    CHECK(joules(at(top + glm::vec3(0, 10 * h, 0), down).inFront(0.01F, 2 * h).catching(1)) < 0.2);
    CHECK(joules(at(top, -down).inFront(0, 4 * h)) == 0);
    // Full catch on the plate, half at its edge, none next to it.
    CHECK(joules(at(top, down).catching(1)) == Approx(1).epsilon(0.01));
    CHECK(joules(at(edge, down).catching(1)) == Approx(0.5).epsilon(0.03));
    CHECK(joules(at(edge, down).catching(0.25F)) == Approx(1));
    CHECK(joules(at(edge + glm::vec3(8 * h, 0, 0), down).catching(1)) < 1e-3);
}

TEST_CASE("Evaporation holds an overheated surface near its boiling point", "[heat]") {
    Material m = steelLike();
    m.boilingPoint = 3100;
    m.vaporisationHeat = 6e6;
    m.molarMass = 0.056;
    const float h = 1e-3F;
    const glm::vec3 high(0.02F, 0.006F, 0.02F);
    const MetalLattice lattice = MetalLattice::covering(glm::vec3(0), high, h);
    const auto seeds = latticeSeeds(lattice, glm::vec3(0), high, 300);
    HeatSettings settings;
    settings.ledger = true;
    settings.evaporation = true;
    HeatRig bench(test::shaders(), lattice, m, seeds, settings);
    const double before = bench.state.readEnergy();
    const auto source = HeatSource::gaussian({0.01F, high.y, 0.01F}, {0, -1, 0}, 1.5F * h, 6000);
    bench.run(0, 0.5, 4000, [&](double) { return std::vector{source}; });
    const auto temperatures = bench.readTemperatures();
    const double hottest = *std::max_element(temperatures.begin(), temperatures.end());
    CHECK(hottest > 2900);
    CHECK(hottest < 3400);
    const HeatBalance balance = bench.solver.readBalance();
    CHECK(balance.lost > 0);
    CHECK(bench.state.readEnergy() - before == Approx(balance.gained - balance.lost).epsilon(1e-6));
}
