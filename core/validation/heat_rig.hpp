// The common rig of the heat cases: a metal block with its solver, run in even steps, and reading fields between
// particles.
#pragma once

#include "core/metal/heat/heat.hpp"
#include "core/validation/validation.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

/// A metal state with its heat solver.
struct HeatRig {
    HeatRig(gl::ShaderLibrary& shaders, const MetalLattice& lattice, const Material& material,
            std::span<const MetalSeed> seeds, const HeatSettings& settings, double liquidConductivityFactor = 1);

    /// Returns the least number of equal steps that make `seconds`, none longer than the solver's longest for `hottest`
    /// (K).
    size_t stepsFor(double seconds, double hottest) const;

    /// Makes that number of equal steps from time `from` to `to` (s). `sources` returns the burning sources at a time,
    /// and is called for the middle of each step. Returns the number of steps.
    size_t run(double from, double to, double hottest, const std::function<std::vector<HeatSource>(double)>& sources);

    std::vector<double> readTemperatures() const;    ///< K, one a particle
    std::vector<double> readLiquidFractions() const; ///< shares of liquid, one a particle

    MetalState state;
    HeatSolver solver;
};

/// Returns the material of a closed form: the solid's properties as they are at `solidAt` (K), the liquid's as at
/// `liquidAt`, melting sharply midway between solidus and liquidus; one density, the solid's.
Material constantMaterial(const Material& material, double solidAt, double liquidAt);

/// Returns the material of a closed form without melting: the solid's properties at `temperature` (K), however hot it
/// gets.
Material unmeltingMaterial(const Material& material, double temperature);

/// Returns no source at all.
std::vector<HeatSource> nothingBurns(double time);

/// Returns the value at `x` of the polynomial through the points (Lagrange).
double interpolate(std::span<const double> places, std::span<const double> values, double x);

} // namespace meltpool
