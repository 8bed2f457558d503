// Validation cases of the flow: drops, pools, a dam, plates.
#include "core/base/error.hpp"
#include "core/validation/case_size.hpp"
#include "core/validation/exact_solutions.hpp"
#include "core/validation/flow_experiments.hpp"
#include "core/validation/validation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kGravity = 9.81; // m/s²

/// Returns the case's liquid at its liquidus.
FlowFluid liquidOf(const ValidationCase& from) {
    const Material& material = from.material;
    FlowFluid fluid;
    fluid.spacing = from.spacing;
    fluid.density = material.liquidDensity.at(material.liquidus);
    fluid.tension = material.tensionAt(material.liquidus);
    fluid.viscosity = material.viscosity.at(material.liquidus);
    return fluid;
}

double radiusOf(const ValidationCase& from) {
    return from.number("radius_mm") * 1e-3;
}

void checkSteps(const ValidationCase& from, const FlowFluid& fluid) {
    requireSteps(from, from.time / FlowConstants::of(fluid).longestStep);
}

void tellRun(ValidationResult& result, const FlowRun& run) {
    result.particles = run.particles;
    result.steps = run.steps;
    if (run.faults.any())
        result.tell("overfull_cells_or_lists", run.faults.cellsOverfull + run.faults.neighboursOverfull);
}

/// Makes the spacing such that `length` (m) is a whole number of it, and reports it; at least `least` of them.
void fitSpacing(const ValidationCase& from, std::string_view key, double length, double least, FlowFluid& fluid,
                ValidationResult& result) {
    requireSpacings(from, key, length, least);
    fluid.spacing = result.spacing = length / std::round(length / from.spacing);
}

/// Checks a free drop in the space of the experiments: a box of four radii.
void checkDrop(const ValidationCase& from) {
    requireSpacings(from, "radius_mm", radiusOf(from), 2);
    const double radius = radiusOf(from) / from.spacing;
    const double count = 4.2 * std::pow(radius, 3);
    requireCapacity(from, {0, count, count, std::pow(4 * radius, 3)});
}

/// Checks a slab that repeats every eight spacings, with walls of three layers; its extent in the other two in m.
void checkSlab(const ValidationCase& from, double length, double height) {
    const double count = (length / from.spacing + 6) * (height / from.spacing + 12) * 8;
    requireCapacity(from, {0, count, count, count});
}

/// Friction between the dam's floor and the water. It is finer than the particles and does not depend on them, like the
/// contact angle below. A laminar layer a tenth of a second old gives 0.015 of the friction that would hold the
/// particles fast, a turbulent one 0.027.
constexpr double kFloorFriction = 0.02;
/// Contact angle (rad): about 75 degrees of water that advances slowly over acrylic (from memory), at the front's
/// capillary number of 0.02 about 97 by the correlation of Jiang, Oh and Slattery 1979.
constexpr double kFloorAngle = 97 * std::numbers::pi / 180;

} // namespace

void runDropletPressure(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    checkDrop(from);
    const FlowFluid fluid = liquidOf(from);
    checkSteps(from, fluid);
    const DropletPressure drop = dropletPressure(shaders, fluid, radiusOf(from), from.time);
    tellRun(result, drop);
    result.compareExact(from, "pressure_jump_pa", exact::dropletPressure(fluid.tension, radiusOf(from)), drop.jump);
    result.tell("density_ratio", drop.density);
    result.tell("rest_speed_mm_s", drop.restSpeed * 1e3);
}

void runDropletOscillation(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    checkDrop(from);
    const FlowFluid fluid = liquidOf(from);
    checkSteps(from, fluid);
    const DropletOscillation drop = dropletOscillation(shaders, fluid, radiusOf(from), from.time);
    tellRun(result, drop);
    result.compareExact(from, "frequency_hz", exact::dropletFrequency(fluid.tension, fluid.density, radiusOf(from)),
                        drop.frequency);
    result.tell("decay_per_s", drop.decay);
}

void runSessileDrop(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    FlowFluid fluid = liquidOf(from);
    const double angle = from.number("contact_angle_deg") * std::numbers::pi / 180;
    const double volume = from.number("volume_mm3") * 1e-9;
    fluid.wetting = wettingForAngle(angle, capillarySpacings(fluid));
    requireSpacings(from, "volume_mm3 (edge of its cube)", std::cbrt(volume), 4);
    // Edge of the wall, twice the spread of the drop.
    const double edge = 1.7 * 2 * std::cbrt(volume) / from.spacing + 12;
    requireCapacity(from, {0, 4 * edge * edge, 4 * edge * edge, edge * edge * edge});
    checkSteps(from, fluid);
    const SessileDrop drop = sessileDrop(shaders, fluid, volume, kGravity, from.time);
    tellRun(result, drop);
    const double height = exact::sessileHeight(fluid.tension, fluid.density, kGravity, volume, angle);
    result.compareExact(from, "height_mm", height * 1e3, drop.height * 1e3);
    result.tell("rest_speed_mm_s", drop.restSpeed * 1e3);
}

void runHydrostatic(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    FlowFluid fluid = liquidOf(from);
    const double height = from.number("height_mm") * 1e-3;
    fitSpacing(from, "height_mm", height, 8, fluid, result);
    checkSlab(from, 8 * from.spacing, height);
    fluid.fastest = std::sqrt(kGravity * height); // limits the bottom's compression to nearly a hundredth
    checkSteps(from, fluid);
    const HydrostaticColumn column = hydrostaticColumn(shaders, fluid, height, kGravity, from.time);
    tellRun(result, column);
    result.compareExact(from, "bottom_pressure_pa", fluid.density * kGravity * height, column.bottomPressure);
    result.compareLimit("density_error_percent", from.tolerancePercent, 100 * column.densityError);
    result.tell("rest_speed_mm_s", column.restSpeed * 1e3);
}

void runDamBreak(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    FlowFluid fluid = liquidOf(from);
    const double width = from.number("width_mm") * 1e-3;
    fitSpacing(from, "width_mm", width, 6, fluid, result);
    checkSlab(from, 15 * width, 2 * width);
    fluid.fastest = std::sqrt(2 * kGravity * 2 * width);
    fluid.wallFriction = kFloorFriction;
    fluid.wetting = wettingForAngle(kFloorAngle, capillarySpacings(fluid));
    const double unit = std::sqrt(width / (2 * kGravity));
    std::vector<double> times, fronts;
    for (const auto& [time, front] : exact::damBreakFront()) {
        if (time * unit > from.time) break;
        times.push_back(time * unit);
        fronts.push_back(front);
    }
    if (times.empty()) throw InputError(from.file, 0, "time_s ends before the first measured front");
    checkSteps(from, fluid);
    const DamBreak dam = damBreak(shaders, fluid, width, kGravity, times);
    tellRun(result, dam);
    double sum = 0;
    for (size_t i = 0; i < times.size(); ++i) {
        const double ours = dam.fronts[i] / width;
        result.tell("front_" + std::to_string(i + 1), ours);
        sum += 100 * std::abs(ours / fronts[i] - 1) / static_cast<double>(times.size());
    }
    result.compareLimit("front_error_mean_percent", from.tolerancePercent, sum);
}

void runPoiseuille(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    FlowFluid fluid = liquidOf(from);
    const double gap = from.number("gap_mm") * 1e-3;
    const double force = from.number("body_force_n_m3");
    fitSpacing(from, "gap_mm", gap, 4, fluid, result);
    checkSlab(from, 8 * from.spacing, gap);
    const auto exactAt = [&](double y) {
        return exact::poiseuille(force, fluid.viscosity, fluid.density, gap, y, from.time);
    };
    const double centre = exactAt(gap / 2);
    fluid.tension = 0; // no free surface: a stiff liquid without cohesion, at its own viscosity
    fluid.leastViscosity = 0;
    fluid.fastest = 4 * std::abs(centre);
    checkSteps(from, fluid);
    const PlateFlow flow = plateFlow(shaders, fluid, gap, force, from.time);
    tellRun(result, flow);
    double sum = 0, count = 0, square = 0;
    for (size_t i = 0; i < flow.places.size(); ++i) {
        const double error = flow.velocities[i] - exactAt(flow.places[i]);
        square += error * error / static_cast<double>(flow.places.size());
        if (std::abs(flow.places[i] - gap / 2) > fluid.spacing) continue;
        sum += centre + error; // shifted to the centre along the exact profile
        count += 1;
    }
    result.compareExact(from, "velocity_mm_s", centre * 1e3, sum / count * 1e3);
    result.tell("profile_rms_percent", 100 * std::sqrt(square) / std::abs(centre));
}

} // namespace meltpool
