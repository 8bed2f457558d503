#include "core/training/check/torch_bend.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace meltpool {

namespace {

constexpr double kSlowest = 7; // Hz
constexpr double kFastest = 9; // Hz

} // namespace

BentPath::BentPath(const TorchPath& path, const Seam& seam, const TorchBend& bend)
    : path_(path), seam_(seam), bend_(bend) {
    // The generator's numbers, unlike the library's distributions, are the same everywhere.
    std::mt19937 numbers(bend.tremor);
    const auto share = [&] { return static_cast<double>(numbers()) / 4294967296.0; };
    for (auto& axis : swings_)
        for (Swing& swing : axis)
            swing = {std::lerp(kSlowest, kFastest, share()), 2 * std::numbers::pi * share()};
}

/// Of root mean square 1.
double BentPath::swing(size_t axis, double time) const {
    double sum = 0;
    for (const Swing& each : swings_[axis])
        sum += std::sin(2 * std::numbers::pi * each.frequency * time + each.phase);
    return sum * std::sqrt(2.0 / kSwings);
}

void BentPath::tremble(TorchSample& torch, double time) const {
    const auto place = [&](size_t axis) { return static_cast<float>(bend_.tremorPlace * swing(axis, time)); };
    const auto angle = [&](size_t axis) { return static_cast<float>(bend_.tremorAngle * swing(axis, time)); };
    torch.tip += glm::vec3(place(0), place(1), place(2));
    torch.orientation =
        torch.orientation * glm::angleAxis(angle(3), glm::vec3(1, 0, 0)) * glm::angleAxis(angle(4), glm::vec3(0, 1, 0));
}

TorchSample BentPath::sample(double time) const {
    TorchSample torch = path_.sample(time / bend_.time);
    torch.time = time;
    torch.tip -= torch.axis() * static_cast<float>(bend_.farther);
    const SeamFrame frame = seam_.at(seam_.nearest(torch.tip).place);
    // Right-handed about the tangent turns `up` towards `across`, which is tangent x up.
    const glm::quat turn = glm::angleAxis(static_cast<float>(bend_.turn), glm::vec3(frame.tangent));
    const glm::vec3 point(frame.point);
    torch.tip = point + turn * (torch.tip - point) + static_cast<float>(bend_.aside) * glm::vec3(frame.across);
    torch.orientation = turn * torch.orientation;
    if (bend_.tremor != 0) tremble(torch, time);
    return torch;
}

} // namespace meltpool
