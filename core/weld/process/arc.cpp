#include "core/weld/process/arc.hpp"

#include "core/gl/state_archive.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;

} // namespace

std::string_view arcActionName(ArcAction action) {
    constexpr std::array<std::string_view, 6> kNames{"out", "striking", "burning", "shorting", "stubbed", "breaking"};
    return kNames[static_cast<size_t>(action)];
}

std::string_view noArcName(NoArc reason) {
    constexpr std::array<std::string_view, 12> kNames{"burns",      "released", "too_long", "touched",
                                                      "metal_left", "no_metal", "too_far",  "touching",
                                                      "feeding",    "no_wire",  "stuck",    "used_up"};
    static_assert(kNames.size() == static_cast<size_t>(NoArc::usedUp) + 1);
    return kNames[static_cast<size_t>(reason)];
}

void ArcState::transfer(gl::StateArchive& archive) {
    archive.values(action, noArc, distance, extension, length, current, voltage, power, radius, pressure, shorts, share,
                   stretch, liquid, rodEaten, rodBall, rodInPool);
}

double arcHeatRadius(double length, double current) {
    const double millimetres = std::max(length, kShortestSpread) / kMm;
    return kArcSpread * 0.53 * kMm * std::pow(millimetres, 0.29) * std::pow(std::max(current, 1.0), 0.30);
}

double arcStirring(double current) {
    return 1 + std::max(current, 0.0) / kStirringCurrent;
}

StirringShares pulledStirring(double pull) {
    const double outwards = std::clamp(pull / kWholePull, -1.0, 1.0);
    const auto share = [](double against) { return 1 - (1 - kLeastStirring) * std::max(against, 0.0); };
    return {share(-outwards), share(outwards)};
}

glm::vec3 stirringLess(const StirringShares& shares, glm::vec3 axis) {
    const auto along = static_cast<float>(shares.along), down = static_cast<float>(shares.down);
    return glm::vec3(1 - along) + (along - down) * axis * axis;
}

} // namespace meltpool
