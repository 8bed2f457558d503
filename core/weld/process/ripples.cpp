#include "core/weld/process/ripples.hpp"

#include "core/weld/process/processes.hpp"

#include <cmath>

namespace meltpool {

namespace {

constexpr FreezingRipples kDip{10, 1}, kSpray{16, 0.5F}, kStick{7, 1.5F}, kTungsten{6, 0.7F}, kFlame{4, 0.7F};

/// At the current that melts the wire as fast as it is fed.
FreezingRipples ripplesOfWire(const GmawSettings& settings) {
    const auto diameter = static_cast<double>(settings.wireDiameterMm);
    const double current = WireMelting::steel(diameter * 1e-3)
                               .current(static_cast<double>(settings.wireFeedMPerMin) / 60,
                                        static_cast<double>(settings.stickOutMm) * 1e-3);
    const auto sprays = static_cast<float>(sprayShare(current, diameter));
    return {std::lerp(kDip.frequency, kSpray.frequency, sprays), std::lerp(kDip.height, kSpray.height, sprays)};
}

} // namespace

FreezingRipples ripplesOf(const ProcessSettings& settings) {
    if (settings.is<Gmaw>()) return ripplesOfWire(settings.of<Gmaw>());
    if (settings.is<Smaw>()) return kStick;
    if (settings.is<Gtaw>()) return kTungsten;
    if (settings.is<Flame>()) return kFlame;
    return {};
}

} // namespace meltpool
