// Heat into a half-space: held surface, constant flux, melting fronts. The half-space is modelled by a column of one
// tile's section.
#include "core/validation/case_size.hpp"
#include "core/validation/exact_solutions.hpp"
#include "core/validation/heat_rig.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kLeastLayers = 6; // layers for a look between layers, and some more
constexpr double kSection = TILE_EDGE * TILE_EDGE;

/// A column along x from the surface at x = 0; one layer before it is a held wall for a `wall` above 0 K.
struct Column {
    Column(const ValidationCase& from, const Material& material, gl::ShaderLibrary& shaders, double depth,
           double initial, double wall)
        : spacing(from.spacing), wallTemperature(wall) {
        const double layers = std::max(kLeastLayers, std::ceil(depth / spacing));
        requireCapacity(from, {(layers + 4) * kSection, (layers + 1) * kSection, 0, 0});
        cells = static_cast<int>(layers);
        const auto h = static_cast<float>(spacing);
        // One layer of air or wall is before the surface.
        const glm::vec3 low(-h, 0, 0);
        const glm::vec3 high(h * static_cast<float>(cells), h * TILE_EDGE, h * TILE_EDGE);
        const MetalLattice lattice = MetalLattice::covering(low, high, h);
        auto seeds = latticeSeeds(lattice, {0, 0, 0}, high, static_cast<float>(initial));
        if (wall > 0) {
            const auto held = latticeSeeds(lattice, low, {0, high.y, high.z}, static_cast<float>(wall), PHASE_HELD);
            seeds.insert(seeds.end(), held.begin(), held.end());
        }
        HeatSettings settings;
        settings.ambient = wall > 0 ? std::min(wall, initial) : initial; // no heat is lost; steps fit all from here up
        bench = std::make_unique<HeatRig>(shaders, lattice, material, seeds, settings);
        requireSteps(from, from.time / bench->solver.longestStep(std::max(wall, initial)));
    }

    /// Returns the mean over each layer of a value per particle, the surface's layer first.
    std::vector<double> layers(const std::vector<double>& values) const {
        std::vector<double> sums(static_cast<size_t>(cells), 0.0);
        const auto positions = bench->state.position.read<vec4>(values.size());
        for (size_t i = 0; i < values.size(); ++i) {
            const int layer = static_cast<int>(std::floor(static_cast<double>(positions[i].x) / spacing));
            if (layer >= 0) sums[static_cast<size_t>(layer)] += values[i] / (TILE_EDGE * TILE_EDGE);
        }
        return sums;
    }

    /// Returns the temperature at a depth, from the four nearest layers or the wall.
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

    /// Returns the amount that has melted (or frozen, for a colder wall), as a depth from the surface.
    double changedDepth(bool melts) const {
        double sum = 0;
        for (const double fraction : layers(bench->readLiquidFractions()))
            sum += (melts ? fraction : 1 - fraction) * spacing;
        return sum;
    }

    /// Returns the depth at which the temperature crosses `melting`, between the layers on both sides of it.
    double isotherm(double melting) const {
        const auto temperatures = layers(bench->readTemperatures());
        const double sign = wallTemperature > melting ? 1 : -1;
        double place = 0, before = wallTemperature;
        for (size_t i = 0; i < temperatures.size(); ++i) {
            const double next = (static_cast<double>(i) + 0.5) * spacing;
            if (sign * (temperatures[i] - melting) <= 0)
                return place + (next - place) * (before - melting) / (before - temperatures[i]);
            place = next;
            before = temperatures[i];
        }
        return place;
    }

    double spacing;
    int cells = 0;
    double wallTemperature;
    std::unique_ptr<HeatRig> bench;
};

/// Returns the depth that the heat reaches, with room to spare.
double heatDepth(double alpha, double time, const std::vector<double>& at) {
    const double deepest = at.empty() ? 0 : *std::max_element(at.begin(), at.end()) * 1e-3;
    return std::max(7 * std::sqrt(alpha * time), 1.2 * deepest) + 0.004;
}

double solidDiffusivity(const Material& m) {
    return m.solidConductivity.at(0) / (m.solidDensity.at(0) * m.solidSpecificHeat.at(0));
}

/// A front's problem in SI, with the changing phase (melting or freezing) as the exact solution's liquid: a freezing
/// front is the melting one of temperatures mirrored at the melting point.
struct Front {
    Material material;
    bool onePhase, melts;
    double wall, initial; ///< K
    exact::StefanTwoPhase problem;

    explicit Front(const ValidationCase& from)
        : onePhase(from.kind->name == "stefan_one_phase"), wall(from.number("wall_temperature_k")) {
        const double melting = 0.5 * (from.material.solidus + from.material.liquidus);
        melts = wall > melting;
        initial = onePhase ? melting : from.number("initial_temperature_k");
        material = constantMaterial(from.material, std::min(wall, initial), std::max(wall, initial));
        // Margin for metal at a sharp melting point: only the temperature distinguishes liquid there, and a float
        // rounds it.
        constexpr double kClearly = 2e-3; // K, a few roundings
        initial = melts ? std::min(initial, melting - kClearly) : std::max(initial, melting + kClearly);
        problem = {material.solidDensity.at(0),
                   material.solidConductivity.at(0),
                   material.liquidConductivity.at(0),
                   material.solidSpecificHeat.at(0),
                   material.liquidSpecificHeat.at(0),
                   material.latentHeat,
                   melting,
                   wall,
                   initial};
        if (melts) return;
        std::swap(problem.solidConductivity, problem.liquidConductivity);
        std::swap(problem.solidSpecificHeat, problem.liquidSpecificHeat);
        problem.wall = 2 * melting - wall;
        problem.initial = 2 * melting - initial;
    }

    double changedDiffusivity() const {
        return problem.liquidConductivity / (problem.density * problem.liquidSpecificHeat);
    }
    double largestDiffusivity() const {
        return std::max(changedDiffusivity(),
                        problem.solidConductivity / (problem.density * problem.solidSpecificHeat));
    }
    double exactAt(double time) const {
        const double stefan = problem.liquidSpecificHeat * (problem.wall - problem.melting) / problem.latentHeat;
        const double lambda = onePhase ? exact::stefanOnePhase(stefan) : exact::stefanTwoPhase(problem);
        return exact::stefanFront(lambda, changedDiffusivity(), time);
    }
};

} // namespace

void runConductionStep(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const double wall = from.number("wall_temperature_k");
    const double initial = from.number("initial_temperature_k");
    const Material material = unmeltingMaterial(from.material, initial);
    const double alpha = solidDiffusivity(material);
    const auto& at = from.list("at_mm");
    Column column(from, material, shaders, heatDepth(alpha, from.time, at), initial, wall);
    result.particles = column.bench->state.particles();
    result.steps = column.bench->run(0, from.time, std::max(wall, initial), nothingBurns);
    const auto temperatures = column.layers(column.bench->readTemperatures());
    for (const double depth : at)
        result.compareExact(from, temperatureName(depth),
                            exact::conductionStep(initial, wall, alpha, depth * 1e-3, from.time),
                            column.temperatureAt(temperatures, depth * 1e-3), std::abs(wall - initial));
}

void runConductionFlux(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const double flux = from.number("flux_w_m2");
    const double initial = from.number("initial_temperature_k");
    const Material material = unmeltingMaterial(from.material, initial);
    const double alpha = solidDiffusivity(material);
    const double k = material.solidConductivity.at(0);
    const auto& at = from.list("at_mm");
    Column column(from, material, shaders, heatDepth(alpha, from.time, at), initial, 0);
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
        result.compareExact(from, temperatureName(depth),
                            exact::conductionFlux(initial, flux, k, alpha, depth * 1e-3, from.time),
                            column.temperatureAt(temperatures, depth * 1e-3), std::abs(surface - initial));
}

void runStefan(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const Front front(from);
    const double reference = front.exactAt(from.time);
    Column column(from, front.material, shaders, heatDepth(front.largestDiffusivity(), from.time, {2e3 * reference}),
                  front.initial, front.wall);
    result.particles = column.bench->state.particles();
    // On cells a front goes by jerks: the changed depth waits while the next cell warms up, the isotherm while it
    // melts. Their mean goes evenly, more so over the second half of the time, in which front / sqrt(time) should be
    // constant. If all metal waits at its melting point no cell has to warm up first.
    constexpr int kLooks = 40;
    double now = 0, sum = 0;
    for (int look = 0; look <= kLooks; ++look) {
        const double time = from.time * (0.5 + 0.5 * look / kLooks);
        result.steps += column.bench->run(now, time, std::max(front.wall, front.initial), nothingBurns);
        now = time;
        const double changed = column.changedDepth(front.melts);
        const double ours = front.onePhase ? changed : 0.5 * (changed + column.isotherm(front.problem.melting));
        sum += ours * std::sqrt(from.time / time) / (kLooks + 1);
    }
    result.compareExact(from, "front_mm", reference * 1e3, sum * 1e3);
    result.tell(front.melts ? "melted_mm" : "frozen_mm", column.changedDepth(front.melts) * 1e3);
}

} // namespace meltpool
