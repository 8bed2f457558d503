#include "core/weld/process/process.hpp"

#include "core/gl/state_archive.hpp"
#include "core/metal/flow/flow_constants.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <algorithm>
#include <numbers>

namespace meltpool {

namespace {

/// Spacings by which a pool's surface is deeper off the axis than on it.
constexpr float kPoolDepth = 3;
/// Share of its cross-section on which an arc burns with its whole power, as it stays on the metal at an edge. No
/// source: chosen.
constexpr float kLeastCatch = 0.25F;

} // namespace

void Process::step(const TorchSample& torch, const MetalAhead& ahead, double seconds, const MetalAhead& rodAhead) {
    rodAhead_ = rodAhead;
    arc_ = {};
    arc_.distance = ahead.distance;
    arc_.liquid = ahead.liquid;
    source_ = {};
    pressureRadius_ = 0;
    drops_ = {};
    advance(torch, ahead, seconds);
}

void Process::reset() {
    arc_ = {};
    source_ = {};
    pressureRadius_ = 0;
    drops_ = {};
    filler_.reset();
}

void Process::transfer(gl::StateArchive& archive) {
    arc_.transfer(archive);
    filler_.transfer(archive);
    if (!archive.restores()) return;
    source_ = {};
    pressureRadius_ = 0;
    drops_ = {};
}

ArcPressure Process::pressure() const {
    if (arc_.pressure <= 0) return {};
    return {source_.position, source_.axis, pressureRadius_, arc_.pressure,
            static_cast<float>(kJetDrag) * arc_.pressure};
}

double Process::dropTemperature() const {
    return kDropTemperature;
}

EdgeArrest Process::edgeArrest() const {
    return {kColdAngle * std::numbers::pi / 180, kColdShare, kWarmShare};
}

void Process::heatSurface(const TorchRay& ray, double power) {
    const float shadow = 2 * arc_.radius + kPoolDepth * metal_.spacing;
    source_ = HeatSource::gaussian(ray.origin + ray.axis * arc_.distance, ray.axis, arc_.radius,
                                   static_cast<float>(std::max(power, 0.0)))
                  .inFront(arc_.distance, shadow)
                  .catching(kLeastCatch);
}

void Process::pressSurface(double current, double radius) {
    pressureRadius_ = static_cast<float>(radius);
    arc_.pressure = static_cast<float>(arcPressurePeak(current, radius));
}

double Process::meltWire(double volume, double seconds, const glm::vec3& place, const glm::vec3& velocity,
                         double available) {
    const double cold = metal_.table.enthalpyAt(metal_.ambient);
    const double rate = volume * metal_.density / seconds; // kg/s
    if (!(rate > 0)) return 0;
    const double wanted = metal_.table.enthalpyAt(std::min(dropTemperature(), metal_.boilingPoint)) - cold;
    const double gained = std::clamp(available / rate, 0.0, std::max(wanted, 0.0));
    drops_ = filler_.feed(volume, place, velocity, static_cast<float>(metal_.table.temperatureAt(cold + gained)));
    return rate * gained;
}

} // namespace meltpool
