#include "core/render/effects/wire_drops.hpp"

#include "core/weld/process/weld_constants.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

/// Drawn share of a drop's way while the eye gathers a picture. No source: chosen, so that single drops are seen and no
/// streak from the wire to the pool.
constexpr float kShownWay = 0.1F;

} // namespace

double WireDrops::dropDiameter(double diameter, double speed, double rate) {
    if (rate <= 0) return kThickest * diameter;
    return std::min(std::cbrt(1.5 * speed * diameter * diameter / rate), kThickest * diameter);
}

void WireDrops::step(const ArcEffectsStep& step) {
    const Equipment tools = step.process != nullptr ? equipmentOf(*step.process) : Equipment();
    const double wire = tools.wire;
    burns_ = wire > 0 && step.arc.burns() && step.arc.action != ArcAction::stubbed;
    if (!burns_) return;
    const bool dips = step.arc.action == ArcAction::shorting;
    // The phase of the short circuits is that of the audible ones.
    rate_ = dips ? static_cast<double>(step.arc.shorts) : step.dropRate;
    phase_ = dips ? step.shortPhase : phase_ + rate_ * step.seconds;
    wire_ = static_cast<float>(wire);
    diameter_ = dropDiameter(wire, tools.wireSpeed, rate_);
    // Threshold between the wire's diameter and twice that, see wireDropRate().
    const bool sprays = diameter_ < 1.3 * wire;
    speed_ = sprays ? kSprayDropSpeed : kDropSpeed;
    gap_ = dips ? 0 : step.arc.length;
    end_ = step.wireEnd;
    axis_ = step.axis;
}

void WireDrops::show(std::vector<Spark>& sparks) const {
    if (!burns_ || diameter_ <= 0) return;
    const auto kelvin = static_cast<float>(kDropTemperature);
    const double grown = phase_ - std::floor(phase_);
    const auto hanging = std::max(wire_, static_cast<float>(diameter_ * std::cbrt(grown)));
    sparks.push_back({end_ - axis_ * (0.25F * hanging), 0.5F * hanging, glm::vec3(0), kelvin});
    if (rate_ <= 0) return;
    for (double age = grown / rate_; age * static_cast<double>(speed_) < static_cast<double>(gap_); age += 1 / rate_)
        sparks.push_back({end_ + axis_ * (speed_ * static_cast<float>(age)), static_cast<float>(0.5 * diameter_),
                          axis_ * (speed_ * Spatter::kGathered * kShownWay), kelvin});
}

} // namespace meltpool
