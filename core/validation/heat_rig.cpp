#include "core/validation/heat_rig.hpp"

#include "core/base/error.hpp"

#include <cmath>

namespace meltpool {

HeatRig::HeatRig(gl::ShaderLibrary& shaders, const MetalLattice& lattice, const Material& material,
                 std::span<const MetalSeed> seeds, const HeatSettings& settings, double liquidConductivityFactor)
    : state(lattice, HeatTable(material, liquidConductivityFactor), material.solidDensity.at(settings.ambient),
            seeds.size()),
      solver(shaders, state, material, settings) {
    state.add(seeds);
    solver.refresh();
}

size_t HeatRig::stepsFor(double seconds, double hottest) const {
    return static_cast<size_t>(std::ceil(seconds / solver.longestStep(hottest)));
}

size_t HeatRig::run(double from, double to, double hottest,
                    const std::function<std::vector<HeatSource>(double)>& sources) {
    const size_t steps = stepsFor(to - from, hottest);
    const double step = (to - from) / static_cast<double>(steps);
    // Sources have their places of the middle of a step.
    for (size_t i = 0; i < steps; ++i)
        solver.step(step, sources(from + (static_cast<double>(i) + 0.5) * step));
    return steps;
}

std::vector<double> HeatRig::readTemperatures() const {
    std::vector<double> temperatures;
    for (const vec4& p : state.position.read<vec4>(state.particles())) {
        temperatures.push_back(static_cast<double>(p.w));
        if (!std::isfinite(p.w)) throw RuntimeFault("a temperature is no longer finite");
    }
    return temperatures;
}

std::vector<double> HeatRig::readLiquidFractions() const {
    std::vector<double> fractions;
    for (const vec4& h : state.heat.read<vec4>(state.particles()))
        fractions.push_back(state.table().liquidFractionAt(static_cast<double>(h.x) + static_cast<double>(h.y)));
    return fractions;
}

Material constantMaterial(const Material& material, double solidAt, double liquidAt) {
    Material plain = material;
    const auto hold = [](Property& property, double value) { property = Property::constant(value); };
    hold(plain.solidDensity, material.solidDensity.at(solidAt));
    hold(plain.liquidDensity, material.solidDensity.at(solidAt));
    hold(plain.solidConductivity, material.solidConductivity.at(solidAt));
    hold(plain.solidSpecificHeat, material.solidSpecificHeat.at(solidAt));
    hold(plain.liquidConductivity, material.liquidConductivity.at(liquidAt));
    hold(plain.liquidSpecificHeat, material.liquidSpecificHeat.at(liquidAt));
    plain.solidus = plain.liquidus = 0.5 * (material.solidus + material.liquidus);
    return plain;
}

Material unmeltingMaterial(const Material& material, double temperature) {
    Material plain = constantMaterial(material, temperature, temperature);
    plain.liquidConductivity = plain.solidConductivity;
    plain.liquidSpecificHeat = plain.solidSpecificHeat;
    plain.latentHeat = 0;
    plain.solidus = plain.liquidus = kNeverMelts;
    return plain;
}

std::vector<HeatSource> nothingBurns(double) {
    return {};
}

double interpolate(std::span<const double> places, std::span<const double> values, double x) {
    double sum = 0;
    for (size_t i = 0; i < places.size(); ++i) {
        double weight = 1;
        for (size_t j = 0; j < places.size(); ++j)
            if (j != i) weight *= (x - places[j]) / (places[i] - places[j]);
        sum += weight * values[i];
    }
    return sum;
}

} // namespace meltpool
