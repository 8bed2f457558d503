// The exact solutions against numbers computed independently.
#include "core/validation/exact_solutions.hpp"
#include "tests/support/catch.hpp"

#include <cmath>
#include <numbers>

using namespace meltpool;

TEST_CASE("Conduction into a half-space", "[exact]") {
    CHECK(exact::conductionStep(293, 1500, 6e-6, 1e-3, 1) == Approx(1225.8).margin(0.05));
    CHECK(exact::conductionStep(293, 1500, 6e-6, 2e-3, 1) == Approx(973.4).margin(0.05));
    CHECK(exact::conductionStep(293, 1500, 6e-6, 5e-3, 1) == Approx(472.7).margin(0.05));
    CHECK(exact::conductionFlux(293, 5e6, 30, 6e-6, 0, 0.5) == Approx(618.7).margin(0.05));
    CHECK(exact::conductionFlux(293, 5e6, 30, 6e-6, 1e-3, 0.5) == Approx(478.8).margin(0.05));
    CHECK(exact::conductionFlux(293, 5e6, 30, 6e-6, 3e-3, 0.5) == Approx(336.5).margin(0.05));
}

TEST_CASE("Melting fronts of Stefan and Neumann", "[exact]") {
    CHECK(exact::stefanOnePhase(0.1) == Approx(0.22002).margin(5e-6));
    CHECK(exact::stefanOnePhase(0.5) == Approx(0.46479).margin(5e-6));
    CHECK(exact::stefanOnePhase(1) == Approx(0.62006).margin(5e-6));
    CHECK(exact::stefanOnePhase(2) == Approx(0.80060).margin(5e-6));
    const exact::StefanTwoPhase problem{7000, 30, 30, 700, 700, 2.7e5, 1750, 2500, 293};
    const double lambda = exact::stefanTwoPhase(problem);
    CHECK(lambda == Approx(0.29030).margin(5e-6));
    CHECK(exact::stefanFront(lambda, 30.0 / 7000 / 700, 10) == Approx(4.543e-3).margin(5e-7));
    // Metal at its melting point violates the one-phase problem.
    const exact::StefanTwoPhase warm{7000, 30, 30, 700, 700, 2.7e5, 1750, 2500, 1750};
    CHECK(exact::stefanTwoPhase(warm) == Approx(exact::stefanOnePhase(700 * 750 / 2.7e5)).margin(1e-6));
}

TEST_CASE("Rosenthal's moving sources", "[exact]") {
    const exact::MovingSource source{1500, 5e-3, 30, 6e-6, 293};
    CHECK(exact::rosenthalThick(source, -0.01, 0, 0) == Approx(1088.8).margin(0.05));
    CHECK(exact::rosenthalThick(source, -0.02, 0, 0) == Approx(690.9).margin(0.05));
    CHECK(exact::rosenthalThick(source, 0, 0.005, 0) == Approx(491.2).margin(0.05));
    CHECK(exact::rosenthalThin(source, 0.006, -0.01, 0) == Approx(1085.6).margin(0.05));
    CHECK(exact::rosenthalThin(source, 0.006, -0.02, 0) == Approx(860.7).margin(0.05));
    CHECK(exact::rosenthalThin(source, 0.006, 0, 0.005) == Approx(429.4).margin(0.05));
    CHECK(exact::besselK0(0.1) == Approx(2.4270690247).epsilon(1e-9));
    CHECK(exact::besselK0(1) == Approx(0.4210244382).epsilon(1e-9));
    CHECK(exact::besselK0(10) == Approx(1.778006232e-5).epsilon(1e-9));
    // The place is far behind, where exp and K0 leave a double's range in opposite directions.
    CHECK(std::isfinite(exact::rosenthalThin(source, 0.006, -2, 0)));
}

TEST_CASE("Sources integrate to their power", "[exact]") {
    double sum = 0;
    const double h = 1e-5;
    for (double r = h / 2; r < 0.03; r += h)
        sum += exact::gaussianFlux(1500, 2e-3, r) * 2 * std::numbers::pi * r * h;
    CHECK(sum == Approx(1500).epsilon(1e-4));

    const exact::Goldak goldak{1500, 3e-3, 2e-3, 3e-3, 6e-3, 0.6};
    const double g = 2.5e-4;
    double whole = 0;
    for (double x = -0.02; x < 0.012; x += g)
        for (double y = -0.01; y < 0.01; y += g)
            for (double z = g / 2; z < 0.008; z += g)
                whole += goldak.at(x + g / 2, y + g / 2, z) * g * g * g;
    CHECK(whole == Approx(1500).epsilon(5e-3));
}

TEST_CASE("Drops and channels", "[exact]") {
    CHECK(exact::dropletFrequency(1.8, 7000, 2e-3) == Approx(80.7).margin(0.05));
    CHECK(exact::dropletFrequency(1.8, 7000, 1e-3) == Approx(228).margin(0.5));
    CHECK(exact::dropletPressure(1.8, 1e-3) == Approx(3600));
    const double pi = std::numbers::pi;
    // A tiny drop is a spherical cap, a huge one a puddle.
    CHECK(exact::sessileHeight(1.8, 7000, 9.81, 1e-12, pi / 2) == Approx(std::cbrt(3e-12 / (2 * pi))).epsilon(1e-3));
    CHECK(exact::sessileHeight(1.8, 7000, 9.81, 0.1, pi / 2) ==
          Approx(exact::puddleHeight(1.8, 7000, 9.81, pi / 2)).epsilon(0.03));
    // Flow from rest: zero at the start, the parabola at the end.
    CHECK(exact::poiseuille(1000, 5e-3, 7000, 4e-3, 2e-3, 0) == Approx(0).margin(1e-6));
    CHECK(exact::poiseuille(1000, 5e-3, 7000, 4e-3, 2e-3, 1e3) == Approx(1000 * 16e-6 / (8 * 5e-3)));
    // Just after the start the middle accelerates freely.
    CHECK(exact::poiseuille(1000, 5e-3, 7000, 4e-3, 2e-3, 0.1) == Approx(1000 * 0.1 / 7000).epsilon(1e-3));
    CHECK(exact::damBreakFront().size() == 14);
}

TEST_CASE("How much of a moving source's field has settled", "[exact]") {
    const exact::MovingSource source{1500, 5e-3, 30, 6e-6, 293};
    for (const double r : {2e-3, 10e-3, 40e-3})
        for (const double time : {0.5, 2.0, 8.0}) {
            // Carslaw and Jaeger 10.7: the point source has a closed form.
            const double root = std::sqrt(4 * source.alpha * time);
            const double vt = source.speed * time;
            const double closed = 0.5 * (std::erfc((r - vt) / root) +
                                         std::exp(source.speed * r / source.alpha) * std::erfc((r + vt) / root));
            CHECK(exact::settledShare(source, r, time, false) == Approx(closed).margin(3e-3));
        }
    CHECK(exact::settledShare(source, 10e-3, 1.0, true) < exact::settledShare(source, 10e-3, 2.0, true));
    CHECK(exact::settledShare(source, 10e-3, 1e3, true) == Approx(1));
    CHECK(exact::settledShare(source, 10e-3, 1e-3, true) < 1e-6);
}
