// Heat into a half-space: held surface, constant flux, melting fronts. A column of one tile's section stands for the
// half-space.
#include "core/metal/validation_bench.hpp"
#include "core/metal/validation_exact.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

/// A column along x from the surface at x = 0; one layer before it is a held wall where `wall` is above 0 K.
struct Column {
    Column(const ValidationCase& from, gl::ShaderLibrary& shaders, double depth, double initial, double wall)
        : spacing(from.spacing), cells(static_cast<int>(std::ceil(depth / spacing))), wallTemperature(wall) {
        const auto h = static_cast<float>(spacing);
        // One layer of air or wall lies before the surface.
        const glm::vec3 low(-h, 0, 0);
        const glm::vec3 high(h * static_cast<float>(cells), h * TILE_EDGE, h * TILE_EDGE);
        const MetalLattice lattice = MetalLattice::covering(low, high, h);
        auto seeds = latticeSeeds(lattice, {0, 0, 0}, high, static_cast<float>(initial));
        if (wall > 0) {
            const auto held = latticeSeeds(lattice, low, {0, high.y, high.z}, static_cast<float>(wall), PHASE_HELD);
            seeds.insert(seeds.end(), held.begin(), held.end());
        }
        HeatSettings settings;
        settings.ambient = initial;
        bench = std::make_unique<HeatBench>(shaders, lattice, from.material, seeds, settings);
    }

    /// Mean over each layer of what a particle has, the surface's layer first.
    std::vector<double> layers(const std::vector<double>& values) const {
        std::vector<double> sums(static_cast<size_t>(cells), 0.0);
        const auto positions = bench->state.position.read<vec4>(values.size());
        for (size_t i = 0; i < values.size(); ++i) {
            const int layer = static_cast<int>(std::floor(static_cast<double>(positions[i].x) / spacing));
            if (layer >= 0) sums[static_cast<size_t>(layer)] += values[i] / (TILE_EDGE * TILE_EDGE);
        }
        return sums;
    }

    /// Temperature at a depth, from the four nearest layers or the wall.
    double temperatureAt(const std::vector<double>& temperatures, double depth) const {
        std::vector<double> places;
        std::vector<double> values;
        if (wallTemperature > 0) {
            places.push_back(0);
            values.push_back(wallTemperature);
        }
        for (size_t i = 0; i < temperatures.size(); ++i) {
            places.push_back((static_cast<double>(i) + 0.5) * spacing);
            values.push_back(temperatures[i]);
        }
        const auto above = std::upper_bound(places.begin(), places.end(), depth) - places.begin();
        const auto first = std::clamp<std::ptrdiff_t>(above - 2, 0, std::ssize(places) - 4);
        return interpolate(std::span(places).subspan(static_cast<size_t>(first), 4),
                           std::span(values).subspan(static_cast<size_t>(first), 4), depth);
    }

    /// How much has melted, as a depth from the surface.
    double meltedDepth() const {
        double sum = 0;
        for (const double fraction : layers(bench->readLiquidFractions()))
            sum += fraction * spacing;
        return sum;
    }

    /// Depth at which the temperature crosses `melting`, between the layers on both sides of it.
    double isotherm(double melting) const {
        const auto temperatures = layers(bench->readTemperatures());
        double place = 0, above = wallTemperature;
        for (size_t i = 0; i < temperatures.size(); ++i) {
            const double next = (static_cast<double>(i) + 0.5) * spacing;
            if (temperatures[i] <= melting)
                return place + (next - place) * (above - melting) / (above - temperatures[i]);
            place = next;
            above = temperatures[i];
        }
        return place;
    }

    double spacing;
    int cells;
    double wallTemperature;
    std::unique_ptr<HeatBench> bench;
};

/// How deep the heat gets, with room to spare.
double heatDepth(double alpha, double time, const std::vector<double>& at) {
    const double deepest = at.empty() ? 0 : *std::max_element(at.begin(), at.end()) * 1e-3;
    return std::max(7 * std::sqrt(alpha * time), 1.2 * deepest) + 0.004;
}

double solidDiffusivity(const Material& m, double temperature) {
    return m.solidConductivity.at(temperature) / (m.solidDensity.at(temperature) * m.solidSpecificHeat.at(temperature));
}

} // namespace

void runConductionStep(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const double wall = from.number("wall_temperature_k");
    const double initial = from.number("initial_temperature_k");
    const double alpha = solidDiffusivity(from.material, initial);
    const auto& at = from.list("at_mm");
    Column column(from, shaders, heatDepth(alpha, from.time, at), initial, wall);
    result.particles = column.bench->state.particles();
    result.steps = column.bench->run(0, from.time, std::max(wall, initial), nothingBurns);
    const auto temperatures = column.layers(column.bench->readTemperatures());
    for (const double depth : at)
        result.compareExact(from, "temperature_at_" + millimetres(depth) + "mm_k",
                            exact::conductionStep(initial, wall, alpha, depth * 1e-3, from.time),
                            column.temperatureAt(temperatures, depth * 1e-3), std::abs(wall - initial));
}

void runConductionFlux(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const double flux = from.number("flux_w_m2");
    const double initial = from.number("initial_temperature_k");
    const double alpha = solidDiffusivity(from.material, initial);
    const double k = from.material.solidConductivity.at(initial);
    const auto& at = from.list("at_mm");
    Column column(from, shaders, heatDepth(alpha, from.time, at), initial, 0);
    const double side = TILE_EDGE * from.spacing;
    // A Gaussian far wider than the column is an even flux on its face.
    const auto source = HeatSource::gaussian({0, 0, 0}, {1, 0, 0}, static_cast<float>(1e4 * side),
                                             static_cast<float>(flux * side * side));
    const double surface = exact::conductionFlux(initial, flux, k, alpha, 0, from.time);
    result.particles = column.bench->state.particles();
    result.steps =
        column.bench->run(0, from.time, std::max(surface, initial), [&](double) { return std::vector{source}; });
    const auto temperatures = column.layers(column.bench->readTemperatures());
    for (const double depth : at)
        result.compareExact(from, "temperature_at_" + millimetres(depth) + "mm_k",
                            exact::conductionFlux(initial, flux, k, alpha, depth * 1e-3, from.time),
                            column.temperatureAt(temperatures, depth * 1e-3), std::abs(surface - initial));
}

void runStefan(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const Material& m = from.material;
    const double wall = from.number("wall_temperature_k");
    const bool onePhase = from.kind->name == "stefan_one_phase";
    const double melting = 0.5 * (m.solidus + m.liquidus);
    const double initial = onePhase ? m.solidus : from.number("initial_temperature_k");
    const exact::StefanTwoPhase problem{m.solidDensity.at(initial),
                                        m.solidConductivity.at(initial),
                                        m.liquidConductivity.at(wall),
                                        m.solidSpecificHeat.at(initial),
                                        m.liquidSpecificHeat.at(wall),
                                        m.latentHeat,
                                        melting,
                                        wall,
                                        initial};
    const double alphaLiquid = problem.liquidConductivity / (problem.density * problem.liquidSpecificHeat);
    const double alpha =
        std::max(alphaLiquid, problem.solidConductivity / (problem.density * problem.solidSpecificHeat));
    const double lambda = onePhase ? exact::stefanOnePhase(problem.liquidSpecificHeat * (wall - melting) / m.latentHeat)
                                   : exact::stefanTwoPhase(problem);
    const double front = exact::stefanFront(lambda, alphaLiquid, from.time);
    Column column(from, shaders, heatDepth(alpha, from.time, {2e3 * front}), initial, wall);
    result.particles = column.bench->state.particles();
    // On cells a front goes by jerks: what has melted waits while the next cell warms up, the isotherm while it melts.
    // Their mean goes evenly, more so over the second half of the time, in which front / sqrt(time) should stand still.
    // Where all metal waits at its melting point no cell has to warm up first.
    constexpr int kLooks = 40;
    double now = 0, sum = 0;
    for (int look = 0; look <= kLooks; ++look) {
        const double time = from.time * (0.5 + 0.5 * look / kLooks);
        result.steps += column.bench->run(now, time, wall, nothingBurns);
        now = time;
        const double melted = column.meltedDepth();
        const double ours = onePhase ? melted : 0.5 * (melted + column.isotherm(melting));
        sum += ours * std::sqrt(from.time / time) / (kLooks + 1);
    }
    result.compareExact(from, "front_mm", front * 1e3, sum * 1e3);
    result.tell("melted_mm", column.meltedDepth() * 1e3);
}

} // namespace meltpool
