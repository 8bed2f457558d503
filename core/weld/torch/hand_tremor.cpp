#include "core/weld/torch/hand_tremor.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace meltpool {

namespace {

constexpr double kSlowest = 7; // Hz
constexpr double kFastest = 9; // Hz

} // namespace

HandTremor::HandTremor(std::uint32_t seed) {
    // The generator's numbers, unlike the library's distributions, are equal on every platform.
    std::mt19937 numbers(seed);
    const auto share = [&] { return static_cast<double>(numbers()) / 4294967296.0; };
    for (auto& axis : swings_)
        for (Swing& swing : axis)
            swing = {std::lerp(kSlowest, kFastest, share()), 2 * std::numbers::pi * share()};
}

/// Returns a swing of root mean square 1.
double HandTremor::swing(size_t axis, double time) const {
    double sum = 0;
    for (const Swing& each : swings_[axis])
        sum += std::sin(2 * std::numbers::pi * each.frequency * time + each.phase);
    return sum * std::sqrt(2.0 / kSwings);
}

void HandTremor::shake(TorchSample& torch, double time, double place, double angle) const {
    const auto way = [&](size_t axis) { return static_cast<float>(place * swing(axis, time)); };
    const auto turn = [&](size_t axis) { return static_cast<float>(angle * swing(axis, time)); };
    torch.tip += glm::vec3(way(0), way(1), way(2));
    torch.orientation =
        torch.orientation * glm::angleAxis(turn(3), glm::vec3(1, 0, 0)) * glm::angleAxis(turn(4), glm::vec3(0, 1, 0));
}

} // namespace meltpool
