// Computes the particles' constants from a liquid's physical quantities: sound speed, time step, force prefactors.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace meltpool {

/// Slopes of surface tension over temperature (N/(m K)) at temperatures `step` (K) apart, linear in between, constant
/// beyond: negative ones drive the surface towards the colder metal. All zero: no such force.
struct TensionSlopes {
    double from = 0, step = 100;
    std::array<double, 16> values{};

    bool any() const; ///< true if a slope is not 0
};

/// A liquid's properties at one particle size. SI units.
struct FlowFluid {
    double spacing = 1e-3; ///< m, edge of the cube that a particle represents
    double density = 7000; ///< kg/m³ at rest
    double tension = 1.8;  ///< surface tension, N/m
    TensionSlopes tensionSlopes;
    double viscosity = 6e-3; ///< Pa s
    /// Attraction of the liquid by wall metal relative to its own: 0 repels (contact angle 180 degrees), 1 wets fully.
    /// See wettingForAngle().
    double wetting = 1;
    /// Wetting of wall metal that is too cold to be wetted: in full below `coldBelow` (K); from `warmAbove` (K) on
    /// `wetting` holds, in between a mixture.
    double coldWetting = 1;
    double coldBelow = 0;
    double warmAbove = 0;
    /// Fastest expected flow, m/s: the sound speed is at least ten times it. 0 if surface tension sets the pace.
    double fastest = 0;
    /// Lower bound of kinematic viscosity as a share of sound speed times support; below it surface tension stirs the
    /// liquid. 0 always takes the physical value.
    double leastViscosity = 1.66e-3;
    /// Friction against wall metal: 1 stops the liquid at walls, 0 lets it slip if the boundary layer is thinner than
    /// the particles.
    double wallFriction = 1;
    /// kg/(m³ s), Carman-Kozeny constant of half-molten metal: 180 mu / d², with 10 um between the arms of weld metal's
    /// crystals.
    double mushyDrag = 1e10;
    double expansion =
        0; ///< 1/K, of the volume over temperature: weight follows 1 - expansion (T - referenceTemperature)
    double referenceTemperature = 0; ///< K, the temperature of `density`
    /// Density over rest density, less 1, of liquid that fills a closed space: its pressure prevents voids where the
    /// flow would pull the liquid apart, which soft particles cannot resist. 0 for liquid with a surface of its own.
    double confinement = 0;
};

/// The prefactors of the flow's two sweeps. With H the support, V = spacing³ and the kernel
/// W = (1-q²)⁴ 3465/(512 pi H³), q = r/H.
struct FlowConstants {
    double support;            ///< H = 2.4 spacings, m
    double mass;               ///< mass of a particle, kg
    double soundSpeed;         ///< c, m/s: rho c² spacing / gamma = 12.15 if surface tension sets it
    double scale;              ///< s of the density sum: 1/lattice sum, enlarged by the compression of cohesion
    double kernelSelf;         ///< s V W(0)
    double kinematicViscosity; ///< m²/s, with its lower bound
    double friction;     ///< friction of pairs, m²/s: 10.3 viscosities, calibrated on plates; 10 at many neighbours
    double cohesion;     ///< 2049 gamma V²/H⁵ over the mass, m/s²
    double area;         ///< 0.375 gamma V/H over the mass, m²/s²
    double wallFriction; ///< friction of wall metal against liquid, over that of liquid against liquid
    double mushyDrag;    ///< drag over density, 1/s
    double longestStep;  ///< longest stable time step, s

    /// Computes the constants. The calibration (2049, 0.375, 12.15, 1.2) holds as a whole and for this support.
    static FlowConstants of(const FlowFluid& fluid);

    /// Number of substeps for a time of `seconds`.
    unsigned substeps(double seconds) const;

    /// Pressure (Pa) of a density ratio: rho c² (delta - 1), none below 1.
    double pressure(double density, double delta) const;
};

/// Peak pressure (Pa) of an arc of `current` (A) on the metal whose pressure is exp(-r²/(2 sigma²)) around its axis,
/// sigma in m. The plasma jet presses with mu0 I²/(8 pi) (1 + 2 ln(R2/R1)) in all (Maecker 1955: an arc that widens
/// from R1 to R2), taken for R2/R1 = e^(1/2): mu0 I²/(4 pi), 4 mN at 200 A.
double arcPressurePeak(double current, double sigma);

/// Spacings in a liquid's capillary length sqrt(tension/(density g)): the fineness of its particles for a drop that
/// weight flattens.
double capillarySpacings(const FlowFluid& fluid);

/// The wetting weight whose measured contact angle is `angle` (radians, 0 .. pi), with `spacings` in the capillary
/// length; linear between measurements. Heights of drops of 200 mm³ of steel and more are correct within 3 % at 101
/// degrees; at 45 degrees, without the correction for finer particles, the error is up to 9 %.
double wettingForAngle(double angle, double spacings);

/// Weight of wall metal at `temperature` (K) against liquid, see FlowFluid.
double wettingAt(const FlowFluid& fluid, double temperature);

} // namespace meltpool
