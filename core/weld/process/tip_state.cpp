#include "core/weld/process/tip_state.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;
constexpr float kElectrodeRadius = 1.2e-3F; ///< m, of the common 2.4 mm tungsten
constexpr float kShortArc = 0.35F;          ///< of the right length: about a drop's diameter for 3 mm; none: chosen
constexpr float kFlameReach = 30e-3F;       ///< m: the hot part of a welding flame; none: chosen
constexpr double kLately = 0.05;            ///< s
constexpr float kLetGo = 0.5e-3F;           ///< m off the metal before the next touch is a new one

TipState arcState(const TipGap& gap, float trigger, const TipSounding& metal) {
    TipState state{TipAction::burning, trigger, 0, metal.liquid};
    if (metal.nearest <= gap.radius && metal.ahead <= gap.radius) {
        state.action = gap.shortest > 0 ? TipAction::stubbed : TipAction::idle;
        if (gap.shortest <= 0) state.power = 0;
    } else if (!(metal.ahead <= kBrokenArc * gap.steady))
        return {};
    else if (metal.ahead >= kBreakingArc * gap.steady)
        state.action = TipAction::breaking;
    else if (metal.ahead < gap.shortest)
        state.action = TipAction::shorting;
    state.stretch = std::clamp((metal.ahead / gap.steady - 1) / (kBreakingArc - 1), 0.0F, 1.0F);
    return state;
}

TipState heatState(const TipGap& gap, float trigger, const TipSounding& metal) {
    if (!(metal.nearest < gap.heatReach)) return {};
    const float arriving = 1 - std::max(metal.nearest, 0.0F) / gap.heatReach;
    return {TipAction::burning, trigger * arriving, 0, metal.liquid};
}

} // namespace

TipGap tipGap(const ProcessParameters& p) {
    switch (static_cast<ProcessKind>(p.kind)) {
    case ProcessKind::Flame:
        return {0, 0, 0, kFlameReach};
    case ProcessKind::Iron:
        return {p.tipRadiusMm * kMm, 0, 0, p.tipRadiusMm * kMm};
    case ProcessKind::Gmaw:
        return {p.wireDiameterMm * kMm / 2, p.arcLengthMm * kMm, kShortArc * p.arcLengthMm * kMm, 0};
    case ProcessKind::Tig:
        break;
    }
    return {kElectrodeRadius, p.arcLengthMm * kMm, 0, 0};
}

TipState tipState(const TipGap& gap, float trigger, const TipSounding& sounding) {
    if (!(trigger > 0)) return {};
    const float pulled = std::min(trigger, 1.0F);
    return gap.steady > 0 ? arcState(gap, pulled, sounding) : heatState(gap, pulled, sounding);
}

void TipTouch::update(const TipGap& gap, const TipSounding& sounding, const glm::vec3& velocity, double elapsed) {
    since_ += elapsed;
    const float fading = approach_ * static_cast<float>(std::exp(-elapsed / kLately));
    approach_ = std::max(fading, -glm::dot(velocity, sounding.normal));
    const float off = sounding.nearest - gap.radius;
    if (touching_) {
        touching_ = off <= kLetGo;
    } else if (off <= 0) {
        touching_ = true;
        if (known_) {
            ++count_;
            since_ = 0;
            speed_ = approach_;
        }
    }
    known_ = true;
}

} // namespace meltpool
