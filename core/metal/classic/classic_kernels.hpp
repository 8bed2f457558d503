// The classic model's smoothing kernels: Müller, Charypar, Gross 2003, "Particle-based fluid simulation for interactive
// applications".
#pragma once

#include <cmath>
#include <numbers>

namespace meltpool {

/// The kernels are 0 for r > h. Distances in box units.
struct ClassicKernels {
    explicit ClassicKernels(double h)
        : supportRadius(h),
          poly6Factor(315.0 / (64.0 * std::numbers::pi * std::pow(h, 9))),
          spikyFactor(45.0 / (std::numbers::pi * std::pow(h, 6))) {}

    double supportRadius;
    double poly6Factor; ///< 315 / (64 pi h^9)
    double spikyFactor; ///< 45 / (pi h^6)

    /// 315/(64 pi h^9) (h² - r²)³
    double poly6(double r) const {
        const double inside = supportRadius * supportRadius - r * r;
        return r > supportRadius ? 0 : poly6Factor * inside * inside * inside;
    }
    /// The slope of the spiky kernel along r: -45/(pi h^6) (h - r)²; its gradient is this times the unit vector.
    double spikySlope(double r) const {
        const double inside = supportRadius - r;
        return r > supportRadius ? 0 : -spikyFactor * inside * inside;
    }
    /// Laplacian of the viscosity kernel: 45/(pi h^6) (h - r)
    double viscosityLaplacian(double r) const { return r > supportRadius ? 0 : spikyFactor * (supportRadius - r); }
};

} // namespace meltpool
