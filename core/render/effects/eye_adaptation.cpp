#include "core/render/effects/eye_adaptation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kDisc = 0.015;  // m, radius of the disc that the eye adapts to
constexpr double kSteel = 0.3;   // reflectance of steel about a pool; no source: chosen
constexpr double kForgets = 0.5; // s after which another look is a new one

} // namespace

double poolLight(double intensity, double height) {
    const double cosine = height / std::sqrt(height * height + kDisc * kDisc);
    return kSteel * 2 * intensity * (1 - cosine) / (std::numbers::pi * kDisc * kDisc);
}

double EyeAdaptation::aim(const EyeScene& scene) {
    const double light = scene.passed * (scene.room + scene.drawn * poolLight(scene.arc, scene.height));
    return std::clamp(kGrey / std::max(light, 1e-9), kDarkest, kBrightest);
}

void EyeAdaptation::update(const EyeScene& scene, double elapsed) {
    const double aimed = aim(scene);
    const double pace = aimed < exposure_ ? kDown : kUp;
    const double share = adapted_ ? 1 - std::exp(-elapsed / pace) : 1;
    adapted_ = true;
    exposure_ *= std::pow(aimed / exposure_, share);

    exposed_ = scene.exposed && scene.arc > 0;
    auto& strength = afterImage_.strength;
    if (exposed_) {
        if (sinceLook_ > kForgets) looked_ = 0;
        looked_ += elapsed;
        sinceLook_ = 0;
        afterImage_.towards = scene.towards;
        strength += (1 - strength) * static_cast<float>(1 - std::exp(-elapsed / kBurnsIn));
        return;
    }
    sinceLook_ += elapsed;
    strength *= static_cast<float>(std::exp(-elapsed / kFades));
    if (strength < 0.01F) strength = 0;
}

} // namespace meltpool
