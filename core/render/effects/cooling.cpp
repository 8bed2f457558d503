#include "core/render/effects/cooling.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kStefanBoltzmann = 5.670374e-8; // W/(m² K^4)
constexpr double kEmissivity = 0.8;              // emissivity of its oxide skin, as that of scale
constexpr double kHeatCapacity = 7300.0 * 700;   // J/(m³ K), austenite and liquid, without the heat of freezing
constexpr double kSpeed = 3;                     // m/s, a usual speed of spatter; its rows are computed for it

// Air at 1000 K; tables of air's properties.
constexpr double kAirConductivity = 0.067; // W/(m K)
constexpr double kAirViscosity = 1.2e-4;   // m²/s, kinematic
constexpr double kPrandtl = 0.70;

constexpr double kStep = 0.002; // share of the temperature that a step of the integration may lose

/// Returns the time (s) in which a drop cools from one temperature to another one near it: Simpson's rule over dt/dT.
double timeOf(double diameter, double from, double to) {
    const double middle = 0.5 * (from + to);
    const auto perKelvin = [diameter](double kelvin) { return -1 / spatterCoolingRate(diameter, kelvin); };
    return (from - to) / 6 * (perKelvin(from) + 4 * perKelvin(middle) + perKelvin(to));
}

double diameterOf(int row, int rows) {
    return kSmallestSpatter * std::pow(kLargestSpatter / kSmallestSpatter, static_cast<double>(row) / (rows - 1));
}

} // namespace

double spatterConvection(double diameter, double speed) {
    const double reynolds = speed * diameter / kAirViscosity;
    return (2 + 0.6 * std::sqrt(reynolds) * std::cbrt(kPrandtl)) * kAirConductivity / diameter;
}

double spatterCoolingRate(double diameter, double kelvin) {
    const double radiated = kEmissivity * kStefanBoltzmann * (std::pow(kelvin, 4) - std::pow(kSpatterAir, 4));
    const double blown = spatterConvection(diameter, kSpeed) * (kelvin - kSpatterAir);
    return -6 * (radiated + blown) / (kHeatCapacity * diameter);
}

SpatterCooling::SpatterCooling() {
    for (int row = 0; row < kSizes; ++row) {
        const double diameter = diameterOf(row, kSizes);
        Row& made = rows_[static_cast<size_t>(row)];
        for (double kelvin = kSpatterBorn; kelvin > kColdest; kelvin *= 1 - kStep)
            made.lifetime += timeOf(diameter, kelvin, std::max(kelvin * (1 - kStep), kColdest));
        double time = 0, kelvin = kSpatterBorn;
        for (int i = 0; i <= kTimes; ++i) {
            const double wanted = made.lifetime * i / kTimes;
            while (kelvin > kColdest) {
                const double next = std::max(kelvin * (1 - kStep), kColdest);
                const double taken = timeOf(diameter, kelvin, next);
                if (time + taken > wanted) break;
                time += taken;
                kelvin = next;
            }
            made.kelvin[static_cast<size_t>(i)] =
                static_cast<float>(kelvin + (wanted - time) * spatterCoolingRate(diameter, kelvin));
        }
    }
}

double SpatterCooling::rowOf(float diameter) {
    const double size = std::clamp(static_cast<double>(diameter), kSmallestSpatter, kLargestSpatter);
    return std::log(size / kSmallestSpatter) / std::log(kLargestSpatter / kSmallestSpatter) * (kSizes - 1);
}

float SpatterCooling::lifetime(float diameter) const {
    const double row = rowOf(diameter);
    const auto low = std::min(static_cast<size_t>(row), static_cast<size_t>(kSizes - 2));
    const double share = row - static_cast<double>(low);
    // Between two sizes the logarithms are almost on a line.
    return static_cast<float>(
        std::exp(std::lerp(std::log(rows_[low].lifetime), std::log(rows_[low + 1].lifetime), share)));
}

float SpatterCooling::temperature(float diameter, float age) const {
    const double row = rowOf(diameter);
    const auto low = std::min(static_cast<size_t>(row), static_cast<size_t>(kSizes - 2));
    const auto share = static_cast<float>(row - static_cast<double>(low));
    const float time = std::clamp(age / lifetime(diameter), 0.0F, 1.0F) * kTimes;
    const auto column = std::min(static_cast<size_t>(time), static_cast<size_t>(kTimes - 1));
    const float part = time - static_cast<float>(column);
    const auto in = [&](const Row& each) { return std::lerp(each.kelvin[column], each.kelvin[column + 1], part); };
    return std::lerp(in(rows_[low]), in(rows_[low + 1]), share);
}

} // namespace meltpool
