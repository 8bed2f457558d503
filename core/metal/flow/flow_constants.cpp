#include "core/metal/flow/flow_constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kSupport = 2.4;       // spacings
constexpr double kLatticeSum = 1.0064; // sum of V W over a cubic lattice of rest density
constexpr double kStiffness = 12.15;   // rho c² spacing / gamma
constexpr double kCompression = 0.2;   // compression by cohesion at that stiffness; true density is 1.0 .. 1.03
constexpr double kCohesion = 2049;
constexpr double kArea = 0.375;
// Lattice sums with this support lack 0 .. 7 % of the continuum's viscosity, by direction.
constexpr double kFriction = 10.3;
// The liquid comes to rest at the wall's surface, half a spacing before its first particles: their friction is larger
// by this factor. Calibrated on the flow between plates.
constexpr double kWallFriction = 2.6;
constexpr double kCourant = 0.585; // longest stable c dt / H

} // namespace

bool TensionSlopes::any() const {
    return std::any_of(values.begin(), values.end(), [](double slope) { return slope != 0; });
}

FlowConstants FlowConstants::of(const FlowFluid& fluid) {
    FlowConstants constants{};
    const double dx = fluid.spacing;
    const double volume = dx * dx * dx;
    const double support = kSupport * dx;
    const double tensionSpeed = std::sqrt(kStiffness * fluid.tension / (fluid.density * dx));
    constants.support = support;
    constants.mass = fluid.density * volume;
    constants.soundSpeed = std::max({tensionSpeed, 10 * fluid.fastest, 1e-3});
    const double share = tensionSpeed / constants.soundSpeed;
    constants.scale = (1 + kCompression * share * share) * (1 + fluid.confinement) / kLatticeSum;
    constants.kernelSelf = constants.scale * volume * 3465 / (512 * std::numbers::pi * support * support * support);
    constants.kinematicViscosity =
        std::max(fluid.viscosity / fluid.density, fluid.leastViscosity * constants.soundSpeed * support);
    constants.friction = kFriction * constants.kinematicViscosity;
    constants.cohesion = kCohesion * fluid.tension * volume * volume / std::pow(support, 5) / constants.mass;
    constants.area = kArea * fluid.tension * volume / support / constants.mass;
    constants.wallFriction = kWallFriction * fluid.wallFriction;
    constants.mushyDrag = fluid.mushyDrag / fluid.density;
    constants.longestStep =
        std::min(kCourant * support / constants.soundSpeed, 0.02 * support * support / constants.kinematicViscosity);
    return constants;
}

unsigned FlowConstants::substeps(double seconds) const {
    return static_cast<unsigned>(std::max(1.0, std::ceil(seconds / longestStep - 1e-6)));
}

double FlowConstants::pressure(double density, double delta) const {
    return density * soundSpeed * soundSpeed * std::max(delta - 1, 0.0);
}

double arcPressurePeak(double current, double sigma) {
    constexpr double kMu0 = 4e-7 * std::numbers::pi; // V s/(A m)
    const double force = kMu0 * current * current / (4 * std::numbers::pi);
    return force / (2 * std::numbers::pi * sigma * sigma);
}

double capillarySpacings(const FlowFluid& fluid) {
    constexpr double kGravity = 9.81; // m/s²
    return std::sqrt(fluid.tension / (fluid.density * kGravity)) / fluid.spacing;
}

double wettingForAngle(double angle, double spacings) {
    // Contact angles (degrees) that drops of 500 mm³ of steel show by the mean height of their highest particles, at 1
    // mm spacing. Their highest point is 1.3 % above the theoretical one for these angles.
    static constexpr std::array<std::array<double, 2>, 10> kMeasured{{{0, 1},
                                                                      {27.2, 0.9},
                                                                      {49.3, 0.8},
                                                                      {68.5, 0.7},
                                                                      {82.2, 0.6},
                                                                      {92.5, 0.5},
                                                                      {103.9, 0.4},
                                                                      {123.7, 0.25},
                                                                      {141.1, 0.1},
                                                                      {180, 0}}};
    // Drops of finer particles show larger angles with the same wetting: steel at 0.7, 0.6 and 0.5 mm, with 7.3 and
    // more spacings in the capillary length. Without this term their heights are up to 5 % too large at 0.75 and 0.85
    // mm.
    constexpr double kFinerAngle = 5, kFrom = 6.9, kWhole = 7.3;
    const double finer = std::clamp((spacings - kFrom) / (kWhole - kFrom), 0.0, 1.0) * kFinerAngle;
    const double degrees = std::clamp(angle * 180 / std::numbers::pi - finer * std::sin(angle), 0.0, 180.0);
    for (size_t i = 1; i < kMeasured.size(); ++i)
        if (degrees <= kMeasured[i][0]) {
            const double share = (degrees - kMeasured[i - 1][0]) / (kMeasured[i][0] - kMeasured[i - 1][0]);
            return kMeasured[i - 1][1] + share * (kMeasured[i][1] - kMeasured[i - 1][1]);
        }
    return 0;
}

double wettingAt(const FlowFluid& fluid, double temperature) {
    const double share = (temperature - fluid.coldBelow) / std::max(fluid.warmAbove - fluid.coldBelow, 1.0);
    return std::lerp(fluid.coldWetting, fluid.wetting, std::clamp(share, 0.0, 1.0));
}

} // namespace meltpool
