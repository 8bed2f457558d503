// The cost of a step of the classic metal: the grid from thousands to a million particles, compared with all pairs.
#include "core/metal/classic/classic_metal.hpp"
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kNeighbours = 30;
constexpr int kMeltingSteps = 90;

/// Makes everything liquid, at random places, at rest density, with a support radius that reaches about 30 neighbours;
/// the time step is so short that this holds while it is measured.
void prepareLiquid(ClassicMetal& metal, size_t particles) {
    const double number = static_cast<double>(particles); // in a cube of volume 1
    ClassicParameters& p = metal.parameters;
    p.supportRadius = static_cast<float>(std::cbrt(kNeighbours / (4.0 / 3.0 * std::numbers::pi * number)));
    p.particleMass = p.restDensity / static_cast<float>(particles);
    p.timeStep = 1e-5F;
    p.solidifyRate = 0;
    ClassicMetal::Snapshot state = metal.snapshot();
    for (glm::vec4& place : state.positions)
        place.w = 1;
    metal.restore(state);
}

/// Measures steps. `cpu_ms` is the time of all this program's threads: if the processor draws, the figure that other
/// programs on the machine disturb least.
BenchRow measureSteps(Bench& bench, const std::string& what, ClassicMetal& metal, const ClassicSource& source) {
    double processor = std::numeric_limits<double>::infinity();
    BenchRow row = bench.measure(what, [&](gl::Profiler& profiler) {
        const std::clock_t start = std::clock();
        metal.step(source, &profiler);
        glFinish();
        processor = std::min(processor, static_cast<double>(std::clock() - start) * 1e3 / CLOCKS_PER_SEC);
    });
    row.particles = metal.particles().count;
    row.bytes = metal.bytes();
    row.bytesPerParticle = static_cast<double>(row.bytes) / static_cast<double>(row.particles);
    row.further = {{"ns_per_particle", row.stepMs * 1e6 / static_cast<double>(row.particles)}, {"cpu_ms", processor}};
    return row;
}

double further(const BenchRow& row, std::string_view name) {
    const auto found =
        std::find_if(row.further.begin(), row.further.end(), [&](const auto& f) { return f.first == name; });
    return found == row.further.end() ? 0 : found->second;
}

/// Adds the row's cost over another's, times `factor`, in wall and in processor time.
void addRatio(BenchRow& row, const std::string& name, const BenchRow& other, double factor) {
    row.further.emplace_back(name, row.stepMs / other.stepMs * factor);
    row.further.emplace_back(name + "_cpu", further(row, "cpu_ms") / further(other, "cpu_ms") * factor);
}

} // namespace

void benchClassicMetal(Bench& bench) {
    BenchRow reference; // 65536 particles: reference for the cost per particle among many more
    for (const int particles : {8192, 20032, 65536, 262144, 1048576}) {
        ClassicMetal metal(bench.shaders(), {particles, ClassicSetup::kRandom, 1});
        prepareLiquid(metal, static_cast<size_t>(particles));
        BenchRow row = measureSteps(bench, "step, 30 neighbours", metal, {});
        if (particles == 65536) reference = row;
        if (particles > 65536)
            addRatio(row, "particle_cost_over_65536", reference, 65536.0 / static_cast<double>(particles));
        bench.add(row);
        if (particles > 20032) continue;
        metal.useAllPairs(true);
        BenchRow pairs = measureSteps(bench, "step, all pairs", metal, {});
        addRatio(pairs, "over_grid", row, 1);
        bench.add(std::move(pairs));
    }
}

void benchClassicThesis(Bench& bench) {
    for (const int particles : {8192, 20032}) {
        ClassicMetal metal(bench.shaders(), {particles, ClassicSetup::kOrdered, 1});
        const ClassicSource flame{glm::vec3(0.55F), 1, false};
        for (int i = 0; i < kMeltingSteps; ++i)
            metal.step(flame, nullptr);
        BenchRow row = measureSteps(bench, "step, thesis values", metal, flame);
        row.further.emplace_back("molten", static_cast<double>(metal.statistics().molten));
        bench.add(std::move(row));
    }
}

} // namespace meltpool
