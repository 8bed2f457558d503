// Cooling of spatter according to its heat equation.
#include "core/render/effects/cooling.hpp"
#include "tests/support/catch.hpp"

#include <cmath>

namespace meltpool {

namespace {

/// Returns the time (s) to cool from one temperature to another, by many short explicit steps of the rate.
double timeToCool(double diameter, double from, double to) {
    constexpr double kStep = 1e-5;
    double time = 0;
    for (double kelvin = from; kelvin > to; time += kStep)
        kelvin += kStep * spatterCoolingRate(diameter, kelvin);
    return time;
}

} // namespace

TEST_CASE("a drop of 0.2 mm cools from 2300 K to 900 K in about 0.15 s, one of 0.5 mm in 0.7 s", "[effects]") {
    CHECK(timeToCool(0.2e-3, 2300, 900) == Approx(0.15).epsilon(0.1));
    CHECK(timeToCool(0.5e-3, 2300, 900) == Approx(0.7).epsilon(0.1));
}

TEST_CASE("air takes up heat from a drop by Ranz and Marshall's law, twice its conduction where it stands still",
          "[effects]") {
    CHECK(spatterConvection(0.2e-3, 0) == Approx(2 * 0.067 / 0.2e-3));
    // Re = 3 m/s 0.2 mm / 1.2e-4 m²/s = 5: Nu = 2 + 0.6 sqrt(5) 0.7^(1/3) = 3.19
    CHECK(spatterConvection(0.2e-3, 3) == Approx(3.19 * 0.067 / 0.2e-3).epsilon(1e-3));
}

TEST_CASE("the rate is the balance of radiation, air and heat content", "[effects]") {
    const double flux = 0.8 * 5.670374e-8 * (std::pow(1500.0, 4) - std::pow(293.15, 4)) +
                        spatterConvection(0.3e-3, 3) * (1500 - 293.15);
    CHECK(spatterCoolingRate(0.3e-3, 1500) * 7300 * 700 * 0.3e-3 / 6 == Approx(-flux).epsilon(1e-6));
    CHECK(spatterCoolingRate(0.3e-3, kSpatterAir) == Approx(0).margin(1e-9));
}

TEST_CASE("the table follows the equation for every size and age", "[effects]") {
    const SpatterCooling cooling;
    for (const double diameter : {0.1e-3, 0.13e-3, 0.2e-3, 0.37e-3, 0.5e-3, 0.81e-3, 1.0e-3}) {
        const auto size = static_cast<float>(diameter);
        CHECK(double(cooling.lifetime(size)) == Approx(timeToCool(diameter, 2300, 700)).epsilon(0.01));
        CHECK(cooling.temperature(size, 0) == Approx(2300));
        double kelvin = 2300, time = 0;
        for (int i = 1; i < 20; ++i) {
            for (const double end = i * double(cooling.lifetime(size)) / 20; time < end; time += 1e-5)
                kelvin += 1e-5 * spatterCoolingRate(diameter, kelvin);
            INFO(diameter * 1e3 << " mm after " << time << " s");
            CHECK(double(cooling.temperature(size, float(time))) == Approx(kelvin).epsilon(0.01));
        }
        CHECK(cooling.temperature(size, 100) == Approx(SpatterCooling::kColdest));
    }
}

} // namespace meltpool
