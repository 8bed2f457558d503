#include "core/validation/exact_solutions.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace meltpool::exact {

namespace {

constexpr double kPi = std::numbers::pi;

/// Returns the root of a rising function by bisection.
double bisect(double low, double high, const std::function<double(double)>& rising) {
    for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
        const double middle = 0.5 * (low + high);
        (rising(middle) < 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace

double conductionStep(double initial, double wall, double alpha, double x, double time) {
    return initial + (wall - initial) * std::erfc(x / (2 * std::sqrt(alpha * time)));
}

double conductionFlux(double initial, double flux, double conductivity, double alpha, double x, double time) {
    const double spread = std::sqrt(alpha * time);
    return initial +
           flux / conductivity *
               (2 * spread / std::sqrt(kPi) * std::exp(-x * x / (4 * alpha * time)) - x * std::erfc(x / (2 * spread)));
}

double stefanOnePhase(double stefan) {
    return bisect(1e-9, 20, [&](double l) { return l * std::exp(l * l) * std::erf(l) - stefan / std::sqrt(kPi); });
}

double stefanTwoPhase(const StefanTwoPhase& p) {
    const double alphaLiquid = p.liquidConductivity / (p.density * p.liquidSpecificHeat);
    const double alphaSolid = p.solidConductivity / (p.density * p.solidSpecificHeat);
    const double nu = std::sqrt(alphaLiquid / alphaSolid);
    const double stefanLiquid = p.liquidSpecificHeat * (p.wall - p.melting) / p.latentHeat;
    const double stefanSolid = p.solidSpecificHeat * (p.melting - p.initial) / p.latentHeat;
    return bisect(1e-6, 5, [&](double l) {
        return l * std::sqrt(kPi) - stefanLiquid / (std::exp(l * l) * std::erf(l)) +
               stefanSolid / (nu * std::exp(nu * nu * l * l) * std::erfc(nu * l));
    });
}

double stefanFront(double lambda, double alpha, double time) {
    return 2 * lambda * std::sqrt(alpha * time);
}

double rosenthalThick(const MovingSource& s, double xi, double y, double z) {
    const double r = std::sqrt(xi * xi + y * y + z * z);
    return s.ambient + s.power / (2 * kPi * s.conductivity * r) * std::exp(-s.speed * (xi + r) / (2 * s.alpha));
}

double rosenthalThin(const MovingSource& s, double thickness, double xi, double y) {
    const double scale = s.speed / (2 * s.alpha);
    const double r = std::sqrt(xi * xi + y * y);
    // exp and K0 overflow apart far behind: take the product in one exponent.
    const double x = scale * r;
    const double product =
        x < 600 ? besselK0(x) * std::exp(-scale * xi) : std::sqrt(kPi / (2 * x)) * std::exp(-scale * xi - x);
    return s.ambient + s.power / (2 * kPi * s.conductivity * thickness) * product;
}

double settledShare(const MovingSource& s, double r, double time, bool line) {
    // Heat of age u gives u^-p exp(-r²/(4 alpha u) - v² u/(4 alpha)), p = 3/2 of a point and 1 of a line. With
    // u = (r/v) exp(w) that is exp((1-p) w - a cosh w) dw, a = v r/(2 alpha).
    const double a = s.speed * r / (2 * s.alpha);
    const double end = std::acosh(1 + 60 / a) + (line ? 0 : 1);
    const double oldest = std::log(s.speed * time / r);
    constexpr int kSteps = 2000;
    double young = 0, all = 0;
    for (int i = 0; i <= kSteps; ++i) {
        const double w = end * (2.0 * i / kSteps - 1);
        const double weight = std::exp((line ? 0 : -0.5 * w) - a * (std::cosh(w) - 1));
        all += weight;
        if (w <= oldest) young += weight;
    }
    return young / all;
}

double besselK0(double x) {
    // K0(x) = integral over t from 0 to infinity of exp(-x cosh t); the trapezium converges exponentially.
    const double end = std::acosh(1 + 745 / x);
    constexpr int kSteps = 400;
    const double step = end / kSteps;
    double sum = 0.5 * std::exp(-x);
    for (int i = 1; i <= kSteps; ++i)
        sum += std::exp(-x * std::cosh(i * step));
    return sum * step;
}

double gaussianFlux(double power, double sigma, double r) {
    return power / (2 * kPi * sigma * sigma) * std::exp(-r * r / (2 * sigma * sigma));
}

double Goldak::at(double x, double y, double z) const {
    const double fraction = x >= 0 ? frontFraction : 2 - frontFraction;
    const double length = x >= 0 ? frontLength : rearLength;
    const double peak = 6 * std::sqrt(3.0) * fraction * power / (width * depth * length * kPi * std::sqrt(kPi));
    const double exponent = x * x / (length * length) + y * y / (width * width) + z * z / (depth * depth);
    return peak * std::exp(-3 * exponent);
}

double dropletFrequency(double tension, double density, double radius) {
    return std::sqrt(8 * tension / (density * radius * radius * radius)) / (2 * kPi);
}

double dropletPressure(double tension, double radius) {
    return 2 * tension / radius;
}

double puddleHeight(double tension, double density, double gravity, double contactAngle) {
    return 2 * std::sqrt(tension / (density * gravity)) * std::sin(contactAngle / 2);
}

namespace {

struct Profile {
    double volume = 0;
    double height = 0;
};

/// Returns the drop's profile from its apex (radius of curvature `apex`) down to the slope `contactAngle`.
Profile sessileProfile(double apex, double capillarySquare, double contactAngle) {
    // State over arc length s: r' = cos phi, z' = sin phi, phi' = 2/b + z/l² - sin phi / r, V' = pi r² sin phi.
    struct State {
        double r, z, phi, volume;
    };
    const auto slope = [&](const State& s) {
        const double turn = s.r > 1e-12 * apex ? std::sin(s.phi) / s.r : 1 / apex;
        const double phi = 2 / apex + s.z / capillarySquare - turn;
        return State{std::cos(s.phi), std::sin(s.phi), phi, kPi * s.r * s.r * std::sin(s.phi)};
    };
    const auto along = [](const State& s, const State& d, double h) {
        return State{s.r + h * d.r, s.z + h * d.z, s.phi + h * d.phi, s.volume + h * d.volume};
    };
    const double h = 2e-4 * std::min(apex, std::sqrt(capillarySquare));
    State s{0, 0, 0, 0};
    while (s.phi < contactAngle) {
        const State k1 = slope(s);
        const State k2 = slope(along(s, k1, h / 2));
        const State k3 = slope(along(s, k2, h / 2));
        const State k4 = slope(along(s, k3, h));
        State next = s;
        next = along(next, k1, h / 6);
        next = along(next, k2, h / 3);
        next = along(next, k3, h / 3);
        next = along(next, k4, h / 6);
        if (next.phi >= contactAngle) {
            const double share = (contactAngle - s.phi) / (next.phi - s.phi);
            return {s.volume + share * (next.volume - s.volume), s.z + share * (next.z - s.z)};
        }
        if (next.r <= 0) break;
        s = next;
    }
    return {s.volume, s.z};
}

} // namespace

double sessileHeight(double tension, double density, double gravity, double volume, double contactAngle) {
    const double capillarySquare = tension / (density * gravity);
    const double size = std::cbrt(volume);
    // The volume rises with the apex radius; a puddle's apex is nearly flat, hence the wide bracket, searched in its
    // logarithm.
    const double logarithm = bisect(std::log(0.05 * size) + 100, std::log(1e4 * size) + 100, [&](double l) {
        return sessileProfile(std::exp(l - 100), capillarySquare, contactAngle).volume - volume;
    });
    return sessileProfile(std::exp(logarithm - 100), capillarySquare, contactAngle).height;
}

double poiseuille(double bodyForce, double viscosity, double density, double gap, double y, double time) {
    const double nu = viscosity / density;
    double u = bodyForce / (2 * viscosity) * y * (gap - y);
    for (int n = 0; n < 200; ++n) {
        const double odd = 2 * n + 1;
        const double wave = odd * kPi / gap;
        u -= 4 * bodyForce * gap * gap / (viscosity * kPi * kPi * kPi * odd * odd * odd) * std::sin(wave * y) *
             std::exp(-wave * wave * nu * time);
    }
    return u;
}

std::span<const std::array<double, 2>> damBreakFront() {
    static constexpr std::array<std::array<double, 2>, 14> kFront{{{0.83, 1.22},
                                                                   {1.22, 1.47},
                                                                   {2.00, 2.29},
                                                                   {2.55, 3.00},
                                                                   {3.35, 4.13},
                                                                   {4.03, 4.94},
                                                                   {4.42, 5.88},
                                                                   {5.09, 6.98},
                                                                   {5.69, 7.95},
                                                                   {6.31, 8.97},
                                                                   {6.82, 9.99},
                                                                   {7.44, 10.96},
                                                                   {8.03, 11.98},
                                                                   {8.63, 13.01}}};
    return kFront;
}

} // namespace meltpool::exact
