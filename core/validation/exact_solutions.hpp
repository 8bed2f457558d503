// Exact solutions to compare the metal with: pure functions, SI units.
#pragma once

#include <array>
#include <span>

namespace meltpool::exact {

/// Returns T at depth x (m) in a half-space at `initial` (K) whose surface is held at `wall` from t = 0, diffusivity
/// alpha (m²/s). Carslaw and Jaeger, Conduction of Heat in Solids, 2.5.
double conductionStep(double initial, double wall, double alpha, double x, double time);

/// Returns T in a half-space that takes the constant flux q (W/m²) from t = 0. Carslaw and Jaeger 2.9.
double conductionFlux(double initial, double flux, double conductivity, double alpha, double x, double time);

/// Returns lambda of the one-phase Stefan problem: lambda exp(lambda²) erf(lambda) = stefan / sqrt(pi).
double stefanOnePhase(double stefan);

/// Inputs of the two-phase Stefan problem; equal density of both phases.
struct StefanTwoPhase {
    double density;
    double solidConductivity, liquidConductivity;
    double solidSpecificHeat, liquidSpecificHeat;
    double latentHeat, melting;
    double wall, initial; ///< K; wall above, initial at or below the melting point
};

/// Returns lambda of Neumann's two-phase problem, so that the front is at 2 lambda sqrt(alpha_l t).
double stefanTwoPhase(const StefanTwoPhase& problem);

/// Returns the front position (m) of a Stefan problem.
double stefanFront(double lambda, double alpha, double time);

/// Source that moves along a plate: absorbed power Q (W), speed v (m/s) along +x, properties, plate at `ambient` (K).
struct MovingSource {
    double power, speed, conductivity, alpha, ambient;
};

/// Returns Rosenthal's (1946) point source on a half-space: T at (xi, y, z) relative to the source, xi ahead (m).
double rosenthalThick(const MovingSource& source, double xi, double y, double z);

/// Returns T of Rosenthal's line source through a plate of thickness d (m).
double rosenthalThin(const MovingSource& source, double thickness, double xi, double y);

/// Returns the share, 0 .. 1, of Rosenthal's settled rise at distance r (m) from a source that has burnt for `time`
/// (s); `line`: through the thickness of a thin plate. It is Rosenthal's integral over the ages of the heat, up to
/// `time` only.
double settledShare(const MovingSource& source, double r, double time, bool line);

/// Returns the modified Bessel function of the second kind, order 0, x > 0.
double besselK0(double x);

/// Returns the Gaussian surface flux of power Q (W) and standard deviation sigma (m) at distance r (W/m²).
double gaussianFlux(double power, double sigma, double r);

/// Goldak's double ellipsoid (W/m³), half-axes in m, front and rear fractions adding to 2; x ahead, z down.
/// Goldak, Chakravarti, Bibby 1984; integrates to the power over the half-space z >= 0.
struct Goldak {
    double power, width, depth, frontLength, rearLength, frontFraction;
    double at(double x, double y, double z) const;
};

/// Returns the lowest (quadrupole) oscillation of a free drop, Hz: sqrt(8 gamma/(rho R³))/(2 pi). Rayleigh 1879.
double dropletFrequency(double tension, double density, double radius);

/// Returns the pressure inside a drop over the outside: 2 gamma/R (Pa).
double dropletPressure(double tension, double radius);

/// Returns the height of a large puddle: 2 l_c sin(theta/2), l_c the capillary length (m), theta in rad.
double puddleHeight(double tension, double density, double gravity, double contactAngle);

/// Returns the height (m) of a drop of any size on a plane: the axisymmetric Young-Laplace equation integrated to the
/// contact angle, for the curvature at the top that gives the volume.
double sessileHeight(double tension, double density, double gravity, double volume, double contactAngle);

/// Returns the velocity of a flow between plates `gap` apart that starts from rest under a body force f (N/m³), at
/// distance y from one plate. Series solution, e.g. Batchelor 4.3.
double poiseuille(double bodyForce, double viscosity, double density, double gap, double y, double time);

/// Returns the measurements of Martin and Moyce 1952, column twice as high as wide: (time sqrt(2 g/a), front Z/a).
std::span<const std::array<double, 2>> damBreakFront();

} // namespace meltpool::exact
