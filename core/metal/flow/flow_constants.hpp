// From physical quantities of a liquid to the numbers of its particles: sound speed, time step, force prefactors.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace meltpool {

/// Slope of surface tension over temperature (N/(m K)) at temperatures `step` (K) apart, linear in between, constant
/// beyond: drives the surface towards the colder where negative. All zero: no such force.
struct TensionSlopes {
    double from = 0, step = 100;
    std::array<double, 16> values{};

    bool any() const; ///< is not 0
};

/// A liquid as particles of one size see it. SI units.
struct FlowFluid {
    double spacing = 1e-3; ///< m, edge of the cube that a particle stands for
    double density = 7000; ///< kg/m³ at rest
    double tension = 1.8;  ///< surface tension, N/m
    TensionSlopes tensionSlopes;
    double viscosity = 6e-3; ///< Pa s
    /// How strongly wall metal attracts the liquid against its own kind: 0 repels (contact angle 180
    /// degrees), 1 wets fully. See wettingForAngle().
    double wetting = 1;
    /// The same of wall metal that is too cold to be wetted: all below `coldBelow` (K); from `warmAbove` (K) on
    /// `wetting` holds, in between both in part.
    double coldWetting = 1;
    double coldBelow = 0;
    double warmAbove = 0;
    /// Fastest flow to be expected, m/s: the sound speed is at least ten times it. 0 where surface tension sets the
    /// pace.
    double fastest = 0;
    /// Kinematic viscosity is at least this share of sound speed times support; below it surface tension stirs the
    /// liquid. 0 takes the physical value whatever it is.
    double leastViscosity = 1.66e-3;
    /// Friction against wall metal: 1 holds the liquid fast at walls, 0 lets it slip where the layer that walls hold
    /// back is thinner than the particles.
    double wallFriction = 1;
    /// kg/(m³ s), Carman-Kozeny constant of half-molten metal: 180 mu / d², with 10 um between the arms of weld metal's
    /// crystals.
    double mushyDrag = 1e10;
    double expansion =
        0; ///< 1/K, of the volume over temperature: weight follows 1 - expansion (T - referenceTemperature)
    double referenceTemperature = 0; ///< K, at which metal weighs as `density` says
    /// Density over rest density, less 1, of liquid that fills a closed space: its pressure keeps the liquid together
    /// where the flow would pull it apart, which soft particles cannot resist. 0 for liquid with a surface of its own.
    double confinement = 0;
};

/// The prefactors of the flow's two sweeps. With H the support, V = spacing³ and the kernel
/// W = (1-q²)⁴ 3465/(512 pi H³), q = r/H.
struct FlowConstants {
    double support;            ///< H = 2.4 spacings, m
    double mass;               ///< of a particle, kg
    double soundSpeed;         ///< c, m/s: rho c² spacing / gamma = 12.15 where surface tension sets it
    double scale;              ///< s of the density sum: 1/lattice sum, enlarged by what cohesion compresses
    double kernelSelf;         ///< s V W(0)
    double kinematicViscosity; ///< m²/s, with its lower bound
    double friction;     ///< of pairs, m²/s: 10.3 of it, calibrated on plates; 10 in the limit of many neighbours
    double cohesion;     ///< 2049 gamma V²/H⁵ over the mass, m/s²
    double area;         ///< 0.375 gamma V/H over the mass, m²/s²
    double wallFriction; ///< of wall metal against liquid, times that of liquid against liquid
    double mushyDrag;    ///< over density, 1/s
    double longestStep;  ///< longest stable time step, s

    /// The calibration (2049, 0.375, 12.15, 1.2) belongs together and to this support.
    static FlowConstants of(const FlowFluid& fluid);

    /// Substeps that a time of `seconds` needs.
    unsigned substeps(double seconds) const;

    /// Pressure (Pa) of a density ratio: rho c² (delta - 1), none below 1.
    double pressure(double density, double delta) const;
};

/// Highest pressure (Pa) of an arc of `current` (A) on the metal whose pressure is exp(-r²/(2 sigma²)) around its axis,
/// sigma in m. The plasma jet presses with mu0 I²/(8 pi) (1 + 2 ln(R2/R1)) in all (Maecker 1955: an arc that widens
/// from R1 to R2), taken for R2/R1 = e^(1/2): mu0 I²/(4 pi), 4 mN at 200 A.
double arcPressurePeak(double current, double sigma);

/// Spacings in a liquid's capillary length sqrt(tension/(density g)): how fine its particles are for a drop that weight
/// flattens.
double capillarySpacings(const FlowFluid& fluid);

/// The wetting weight whose contact angle (radians, 0 .. pi) was measured to be `angle`, with so many `spacings` in the
/// capillary length; linear between measurements. Drops of 200 mm³ of steel and more are as high as they should be
/// within 3 % at 101 degrees; at 45 degrees, before finer particles were told apart, they were up to 9 % off.
double wettingForAngle(double angle, double spacings);

/// Weight of wall metal at `temperature` (K) against liquid, see FlowFluid.
double wettingAt(const FlowFluid& fluid, double temperature);

} // namespace meltpool
