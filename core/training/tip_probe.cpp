#include "core/training/tip_probe.hpp"

namespace meltpool {

namespace {

ProbeAim aimOf(const MetalModel& metal, const TorchSample& torch) {
    return {torch.tip / metal.unit(), torch.axis(), TipProbe::kReach / metal.unit()};
}

/// Metres, and nothing where no metal was met.
float distanceOf(float found, const MetalModel& metal) {
    const float metres = found * metal.unit();
    return metres < TipProbe::kReach * 0.999F ? metres : std::numeric_limits<float>::infinity();
}

TipSounding soundingOf(const SurfaceProbeAnswer& found, const MetalModel& metal) {
    TipSounding sounding;
    sounding.ahead = distanceOf(found.ahead, metal);
    sounding.nearest = distanceOf(found.nearest, metal);
    sounding.normal = found.normal;
    if (sounding.ahead < TipProbe::kReach) sounding.liquid = metal.liquidShare(found.temperature);
    return sounding;
}

} // namespace

void TipProbe::request(const Surface& surface, const MetalModel& metal, const TorchSample& torch) {
    probe_.request(surface, aimOf(metal, torch));
}

std::optional<TipSounding> TipProbe::poll(const MetalModel& metal) {
    const auto found = probe_.poll();
    return found ? std::optional(soundingOf(*found, metal)) : std::nullopt;
}

TipSounding TipProbe::now(const Surface& surface, const MetalModel& metal, const TorchSample& torch) {
    return soundingOf(probe_.now(surface, aimOf(metal, torch)), metal);
}

} // namespace meltpool
