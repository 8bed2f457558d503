// Light of an arc that the smoke around it scatters towards the eye.
#pragma once

#include <algorithm>
#include <cmath>

namespace meltpool {

/// Returns the light that a ray gathers on its way from `begin` to `end` through smoke around a point source, whose
/// scattering falls from sigma at the source to 0 in the distance R as 1 - (d/R)²: the integral of sigma (1 - (d/R)²)
/// I/(4 pi d²) is sigma I/(4 pi) ((atan((t1 - b)/h) - atan((t0 - b)/h))/h - (t1 - t0)/R²). The first part is that of
/// even smoke (Sun, Ramamoorthi, Narasimhan, Nayar 2005, "A practical analytic single scattering model for real time
/// rendering"). `intensity`: I; `scattering`: sigma, 1/m; `passing`: h, m of the ray from the source at its nearest
/// point; `nearest`: b, m along the ray to there; `reach`: R, m, infinite for even smoke. Scatters evenly in all
/// directions, and nothing twice.
inline double hazeLight(double intensity, double scattering, double passing, double nearest, double begin, double end,
                        double reach) {
    constexpr double kPi = 3.14159265358979;
    const double h = std::max(passing, 1e-9);
    const double even = (std::atan((end - nearest) / h) - std::atan((begin - nearest) / h)) / h;
    return scattering * intensity / (4 * kPi) * (even - (end - begin) / (reach * reach));
}

} // namespace meltpool
