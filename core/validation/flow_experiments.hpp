// Experiments of the flow with a known outcome; SI units. The validation cases and the tests run them.
#pragma once

#include "core/validation/flow_rig.hpp"

namespace meltpool {

/// Data that every experiment reports about its run.
struct FlowRun {
    size_t particles = 0;
    size_t steps = 0;
    FlowFaults faults;
};

struct DropletPressure : FlowRun {
    double jump = 0;      ///< Pa, mean beyond a support under the surface and over the last third of the time
    double density = 0;   ///< mean density over rest density, averaged as `jump`
    double restSpeed = 0; ///< root mean square speed at the end, m/s
};
/// Runs a drop without gravity, left alone for `seconds`; mean of three that start from different arrangements. The
/// jump is scaled to that of a drop whose particles fill a ball of `radius`.
DropletPressure dropletPressure(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double radius, double seconds);

struct DropletOscillation : FlowRun {
    double frequency = 0; ///< Hz, lowest mode
    double decay = 0;     ///< 1/s
};
/// Runs a drop without gravity, come to rest, then stretched by a tenth and watched for `seconds`, at least three
/// periods; mean of the three axes and of three drops that start from different arrangements. The frequency is scaled
/// to that of a drop whose particles fill a ball of `radius`.
DropletOscillation dropletOscillation(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double radius,
                                      double seconds);

struct SessileDrop : FlowRun {
    double height = 0;    ///< m, highest particles over the wall
    double restSpeed = 0; ///< root mean square speed at the end, m/s
};
/// Runs a drop of `volume` that spreads on a plane for `seconds`; `fluid.wetting` decides the contact angle.
SessileDrop sessileDrop(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double volume, double gravity,
                        double seconds);

struct HydrostaticColumn : FlowRun {
    double bottomPressure =
        0; ///< Pa, mean of the pressures inside, each with the weight of liquid between it and the floor
    double densityError = 0; ///< mean of |rho/rho0 - 1| inside
    double restSpeed = 0;    ///< root mean square speed at the end, m/s
};
/// Runs a wide pool of depth `height` at rest for `seconds`.
HydrostaticColumn hydrostaticColumn(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double height, double gravity,
                                    double seconds);

struct DamBreak : FlowRun {
    std::vector<double> fronts; ///< m from the column's back, for each time asked
};
/// Runs a column `width` wide and twice as high that collapses along a floor; `times` in s, rising.
DamBreak damBreak(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double width, double gravity,
                  std::span<const double> times);

struct PlateFlow : FlowRun {
    /// Places over the gap and velocities, m and m/s; one a particle, at the end.
    std::vector<double> places, velocities;
};
/// Runs liquid between plates `gap` apart that a body force (N/m³) sets going from rest.
PlateFlow plateFlow(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double gap, double bodyForce, double seconds);

/// Returns the height (m) of the highest point of a drop on a plane at y = 0, whose particles are at `places`: half a
/// spacing above the top of the ball through those near the axis that no particle covers. The mean of the highest
/// particles is lower for a curved top: by r²/(4 R) within r of the axis, 5 % of a steel drop of 100 particles.
double apexHeight(std::span<const glm::dvec3> places, double spacing);

/// Frequency (Hz) and decay (1/s) of the damped oscillation that fits evenly spaced samples best.
struct DampedFit {
    double frequency = 0, decay = 0;
};
DampedFit fitDamped(std::span<const double> samples, double interval, double lowestFrequency, double highestFrequency);

} // namespace meltpool
