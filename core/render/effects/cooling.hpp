// Cooling of spatter in flight.
#pragma once

#include <array>

namespace meltpool {

/// K of spatter that leaves the pool: pyrometers measured up to 2000 °C (Energies 2020, 13:6502).
inline constexpr double kSpatterBorn = 2300;
/// K of the air around flying spatter.
inline constexpr double kSpatterAir = 293.15;
/// m, the range of spatter diameters.
inline constexpr double kSmallestSpatter = 0.1e-3, kLargestSpatter = 1e-3;

/// Returns the coefficient (W/(m² K)) from a sphere of `diameter` (m) to air that it flies through at `speed` (m/s), by
/// Ranz and Marshall 1952: Nu = 2 + 0.6 Re^(1/2) Pr^(1/3), with the air of the film between both, at about 1000 K.
double spatterConvection(double diameter, double speed);

/// Returns the rate (K/s) of a steel drop of `diameter` at `kelvin`: rho c d/6 dT/dt = -(eps sigma (T^4 - T0^4) + h (T
/// - T0)). The whole drop has one temperature (its Biot number is below 0.02).
double spatterCoolingRate(double diameter, double kelvin);

/// The solution for drops born at kSpatterBorn as a table, made once: the fourth power in addition to the first has no
/// closed form. Time is counted in units of a drop's lifetime from birth to kColdest, by its size.
class SpatterCooling {
  public:
    /// K below which spatter counts as cold: it no longer glows.
    static constexpr double kColdest = 700;

    SpatterCooling();

    /// Returns the temperature (K) of a drop of `diameter` (m, brought into the range of sizes), `age` s after its
    /// birth; kColdest from then on.
    float temperature(float diameter, float age) const;
    /// Returns the time from birth to kColdest, s.
    float lifetime(float diameter) const;

  private:
    static constexpr int kSizes = 16, kTimes = 64;
    struct Row {
        double lifetime = 0;
        std::array<float, kTimes + 1> kelvin{};
    };
    static double rowOf(float diameter);

    std::array<Row, kSizes> rows_;
};

} // namespace meltpool
