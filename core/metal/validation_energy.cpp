// Where the joules go: an arc melts a spot of a plate, which freezes again; and the melting of a block between two
// walls.
#include "core/metal/validation_bench.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

/// Share of particles that are liquid.
double moltenShare(const MetalState& state) {
    size_t molten = 0;
    for (const uint bits : state.phase.read<uint>(state.particles()))
        molten += (bits & PHASE_LIQUID) ? 1 : 0;
    return static_cast<double>(molten) / static_cast<double>(state.particles());
}

} // namespace

void runEnergy(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    constexpr float kSide = 0.032F;
    constexpr float kThickness = 0.008F;
    constexpr double kAmbient = 293.15;
    constexpr double kHottest = 4000;
    const auto h = static_cast<float>(from.spacing);
    const glm::vec3 low(0, 0, 0);
    const glm::vec3 high(kSide, kThickness, kSide);
    const MetalLattice lattice = MetalLattice::covering(low, high, h);
    const auto seeds = latticeSeeds(lattice, low, high, static_cast<float>(kAmbient));
    const double coefficient = from.number("loss");
    HeatSettings settings;
    settings.ambient = kAmbient;
    settings.convection = coefficient;
    settings.radiation = coefficient > 0;
    settings.ledger = true;
    HeatBench bench(shaders, lattice, from.material, seeds, settings);
    const double power = from.number("power_w");
    const double on = std::min(from.number("on_s"), from.time);
    const float sigma = std::max(0.0015F, 1.5F * h);
    const glm::vec3 place(kSide / 2, kThickness, kSide / 2);
    const auto source = HeatSource::gaussian(place, {0, -1, 0}, sigma, static_cast<float>(power));

    const double before = bench.state.readEnergy();
    result.particles = bench.state.particles();
    if (on > 0) result.steps += bench.run(0, on, kHottest, [&](double) { return std::vector{source}; });
    const double peak = moltenShare(bench.state);
    if (from.time > on) result.steps += bench.run(on, from.time, kHottest, nothingBurns);
    const double after = bench.state.readEnergy();

    const HeatBalance balance = bench.solver.readBalance();
    const double put = power * on;
    const double scale = put > 0 ? put : before;
    result.compareExact(from, "energy_change_j", put - balance.lost, after - before, scale);
    result.compareExact(from, "source_j", put, balance.gained, scale);
    result.tell("lost_j", balance.lost);
    result.tell("balance_percent", 100 * std::abs(after - before - balance.gained + balance.lost) / scale);
    result.tell("molten_peak_share", peak);
    result.tell("molten_end_share", moltenShare(bench.state));
}

void runCavityMelting(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const auto h = static_cast<float>(from.spacing);
    const auto cells = std::max(4.0F, std::round(static_cast<float>(from.number("width_mm") * 1e-3) / h));
    const float width = cells * h;
    // Without flow every level is like the next: one tile of height stands for all.
    const float height = TILE_EDGE * h;
    const glm::vec3 low(-h, 0, 0);
    const glm::vec3 high(width + h, height, height);
    const MetalLattice lattice = MetalLattice::covering(low, high, h);
    auto seeds =
        latticeSeeds(lattice, {0, 0, 0}, {width, height, height}, static_cast<float>(from.number("initial_k")));
    const size_t metal = seeds.size();
    const auto addWall = [&](glm::vec3 a, glm::vec3 b, double temperature) {
        const auto wall = latticeSeeds(lattice, a, b, static_cast<float>(temperature), PHASE_HELD);
        seeds.insert(seeds.end(), wall.begin(), wall.end());
    };
    addWall(low, {0, height, height}, from.number("hot_k"));
    addWall({width, 0, 0}, high, from.number("cold_k"));
    HeatSettings settings;
    settings.ambient = from.number("initial_k");
    settings.wakingKelvin = 1e-5; // the whole drive is ten kelvin
    HeatBench bench(shaders, lattice, from.material, seeds, settings);
    result.particles = metal;
    double now = 0;
    const auto& times = from.list("times_s");
    for (size_t i = 0; i < times.size(); ++i) {
        result.steps += bench.run(now, times[i], from.number("hot_k"), nothingBurns);
        now = times[i];
        const auto fractions = bench.readLiquidFractions();
        double melted = 0;
        for (size_t p = 0; p < metal; ++p)
            melted += fractions[p];
        result.compareMeasured(from, "melted_fraction", melted / static_cast<double>(metal), i);
    }
}

} // namespace meltpool
