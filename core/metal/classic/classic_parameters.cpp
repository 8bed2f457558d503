#include "core/metal/classic/classic_parameters.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 2> kArrangements{"ordered", "random"};

} // namespace

ParameterList describe(ClassicParameters& p) {
    return {
        {"rest_density", "Rest density", "", &p.restDensity, 0, 100000,
         "Density without pressure; above the actual density the metal contracts, below it expands."},
        {"particle_mass", "Particle mass", "", &p.particleMass, 1e-6, 100,
         "Density, pressure and viscosity force grow with it."},
        {"viscosity", "Viscosity", "", &p.viscosity, 0, 1000,
         "Viscosity of the liquid; far above the default the time step is too long and the liquid trembles."},
        {"gas_stiffness", "Gas stiffness", "", &p.gasStiffness, 0, 10000,
         "Pressure per density above rest; high values make the liquid less compressible and burst at long time "
         "steps."},
        {"support_radius", "Support radius", "", &p.supportRadius, 0.01, 1,
         "Distance at which particles interact; the cost grows with its third power."},
        {"gravity", "Gravity", "", &p.gravity, -100, 100, "Acceleration of the liquid, box units per second squared."},
        {"time_step", "Time step", "s", &p.timeStep, 0.00001, 0.1,
         "Simulated time of a step; long steps are fast but unstable."},
        {"wall_restitution", "Wall restitution", "", &p.wallRestitution, 0, 1,
         "Share of the speed that remains when a particle bounces off the box."},
        {"wall_slip", "Slip along walls", "", &p.wallSlip, 0, 1,
         "Off: a bounce reverses the whole velocity. On: only its part normal to the wall, so that liquid slides along "
         "it."},
        {"acceleration_limit", "Acceleration limit", "", &p.accelerationLimit, 0, 100000,
         "Greatest acceleration; high values let strongly compressed liquid burst."},
        {"solidify_rate", "Solidify rate", "", &p.solidifyRate, 0, 1,
         "Temperature lost per step. At 0, molten metal stays liquid."},
        {"heat_radius", "Heat radius", "", &p.heatRadius, 0.0001, 12,
         "Square of the distance that the source reaches."},
        {"heat_temperature", "Heat temperature", "", &p.heatTemperature, 0, 1,
         "Temperature that the source adds per step at its centre."},
    };
}

ParameterList describe(ClassicSetup& s) {
    return {
        {"particles",
         "Particles",
         "",
         &s.particles,
         1,
         4194304,
         "Time and memory grow with it; good results from 8192.",
         {},
         true},
        {"arrangement", "Arrangement", "", &s.arrangement, 0, 1, "A lattice, or random positions.", kArrangements,
         true},
        {"seed", "Seed", "", &s.seed, 0, 2147483647, "Selects other random positions.", {}, true},
    };
}

} // namespace meltpool
