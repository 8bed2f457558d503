#include "core/training/trainer/tip_probe.hpp"

namespace meltpool {

namespace {

ProbeAim aimOf(const MetalModel& metal, const TorchSample& torch) {
    const glm::vec3 end = torch.tip - torch.axis() * metal.burntOff();
    return {end / metal.unit(), torch.axis(), TipProbe::kReach / metal.unit()};
}

/// Distance in metres; empty if no metal was met.
float distanceOf(float found, const MetalModel& metal) {
    const float metres = found * metal.unit();
    return metres < TipProbe::kReach * 0.999F ? metres : std::numeric_limits<float>::infinity();
}

SurfaceDistance surfaceDistance(const SurfaceProbeAnswer& found, const MetalModel& metal) {
    SurfaceDistance surface;
    surface.ahead = distanceOf(found.ahead, metal);
    surface.nearest = distanceOf(found.nearest, metal);
    surface.normal = found.normal;
    if (surface.ahead < TipProbe::kReach) surface.liquid = metal.liquidShare(found.temperature);
    return surface;
}

} // namespace

void TipProbe::request(const Surface& surface, const MetalModel& metal, const TorchSample& torch) {
    probe_.request(surface, aimOf(metal, torch));
}

std::optional<SurfaceDistance> TipProbe::poll(const MetalModel& metal) {
    const auto found = probe_.poll();
    return found ? std::optional(surfaceDistance(*found, metal)) : std::nullopt;
}

SurfaceDistance TipProbe::now(const Surface& surface, const MetalModel& metal, const TorchSample& torch) {
    return surfaceDistance(probe_.now(surface, aimOf(metal, torch)), metal);
}

} // namespace meltpool
