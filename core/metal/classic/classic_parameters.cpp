#include "core/metal/classic/classic_parameters.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 2> kArrangements{"ordered", "random"};

} // namespace

ParameterList describe(ClassicParameters& p) {
    return {
        {"rest_density", "Rest density", "", &p.restDensity, 0, 100000,
         "Density without pressure; above the real one the metal pulls itself together, below it swells."},
        {"particle_mass", "Particle mass", "", &p.particleMass, 1e-6, 100,
         "Density, pressure and viscosity force grow with it."},
        {"viscosity", "Viscosity", "", &p.viscosity, 0, 1000,
         "Toughness of the liquid; far above the default the time step is too long for it and the liquid trembles."},
        {"gas_stiffness", "Gas stiffness", "", &p.gasStiffness, 0, 10000,
         "Pressure per density above rest; high values make the liquid less compressible and burst at long time "
         "steps."},
        {"support_radius", "Support radius", "", &p.supportRadius, 0.01, 1,
         "How far particles feel each other; the work grows with its third power."},
        {"gravity", "Gravity", "", &p.gravity, -100, 100, "Acceleration of everything liquid, per box unit."},
        {"time_step", "Time step", "s", &p.timeStep, 0.00001, 0.1,
         "Model time of a step; long steps are quick and unstable."},
        {"wall_restitution", "Wall restitution", "", &p.wallRestitution, 0, 1,
         "Share of the speed that is left when a particle bounces off the box."},
        {"wall_slip", "Slip along walls", "", &p.wallSlip, 0, 1,
         "Off: a bounce reverses the whole velocity. On: only its part across the wall, so that liquid runs along it."},
        {"acceleration_limit", "Acceleration limit", "", &p.accelerationLimit, 0, 100000,
         "Longest acceleration; high values let badly compressed liquid burst."},
        {"solidify_rate", "Solidify rate", "", &p.solidifyRate, 0, 1,
         "Temperature lost per step; 0: what melted stays liquid."},
        {"heat_radius", "Heat radius", "", &p.heatRadius, 0.0001, 12,
         "Reach of the source; compared with the squared distance."},
        {"heat_temperature", "Heat temperature", "", &p.heatTemperature, 0, 1,
         "Temperature that the source gives per step at its centre."},
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
        {"arrangement", "Arrangement", "", &s.arrangement, 0, 1, "A lattice, or places drawn at random.", kArrangements,
         true},
        {"seed", "Seed", "", &s.seed, 0, 2147483647, "Another number draws other random places.", {}, true},
    };
}

} // namespace meltpool
