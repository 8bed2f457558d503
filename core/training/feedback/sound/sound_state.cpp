#include "core/training/feedback/sound/sound_state.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr float kPulled = 0.05F;       // of a trigger
constexpr float kScratchSpeed = 0.05F; // m/s at which the scratch is loudest
constexpr float kTouches = 0.3e-3F;    // m

/// How a process's noise grows with the arc's length, from the length that the settings give to going out.
struct Hiss {
    float quiet, loud; // level
    float low, high;   // Hz
};

Hiss hissOf(SoundProcess process) {
    switch (process) {
    case SoundProcess::gmaw:
        return {0.020F, 0.110F, 1100, 6000};
    case SoundProcess::gtaw:
        return {0.016F, 0.070F, 1400, 6500};
    case SoundProcess::smaw:
        return {0.020F, 0.080F, 900, 4000};
    default:
        return {};
    }
}

void hearArc(const SoundStep& step, SoundLevels& levels) {
    const ArcState& arc = step.arc;
    const Hiss hiss = hissOf(step.process);
    const float strength = std::clamp(arc.share, 0.0F, 1.0F);
    const bool open = arc.action == ArcAction::burning || arc.action == ArcAction::breaking;
    if (open) {
        levels.hiss = strength * (hiss.quiet + (hiss.loud - hiss.quiet) * arc.stretch);
        levels.hissPitch = hiss.low + (hiss.high - hiss.low) * arc.stretch;
    }
    if (arc.action == ArcAction::shorting) { // what is left of the noise between two short circuits
        levels.hiss = 0.5F * hiss.quiet;
        levels.hissPitch = hiss.low;
    }
    if (step.process == SoundProcess::gmaw && open) {
        levels.drops = 0.07F * strength;
        levels.dropRate = step.dropRate;
    }
    if (step.process == SoundProcess::smaw) {
        levels.crackle = 0.035F + 0.03F * arc.stretch;
        levels.crackleRate = 90 + 110 * arc.stretch;
        levels.cracklePitch = 1500 + 2000 * arc.stretch;
    }
    if (step.alternating > 0 && open) {
        levels.buzz = 0.07F * strength;
        levels.buzzRate = 2 * step.alternating;
    }
    if (arc.action == ArcAction::stubbed) levels.stub = 0.18F;
}

/// The end of an electrode that is drawn over the metal while no arc burns.
float scratchOf(const SoundStep& step) {
    const bool electrode = step.process == SoundProcess::smaw || step.process == SoundProcess::gtaw;
    if (!electrode || step.arc.burns() || step.trigger < kPulled || step.arc.distance > kTouches) return 0;
    return 0.06F * std::clamp(step.tipSpeed / kScratchSpeed, 0.0F, 1.0F);
}

} // namespace

bool SoundLevels::silent() const {
    return hiss + drops + crackle + buzz + roar + gas + stub + scratch <= 0;
}

void SoundState::step(const SoundStep& step) {
    levels_ = {};
    strike_ = 0;
    const bool burned = arc_;
    const bool electric =
        step.process == SoundProcess::gmaw || step.process == SoundProcess::gtaw || step.process == SoundProcess::smaw;
    arc_ = electric && step.arc.burns();
    if (arc_) hearArc(step, levels_);
    if (arc_ && !burned) strike_ = std::clamp(step.arc.voltage * step.arc.current, 0.1F * kFullArcPower, kFullArcPower);
    if (step.process == SoundProcess::flame && step.trigger >= kPulled) levels_.roar = 0.10F * step.trigger;
    levels_.scratch = scratchOf(step);
    followGas(step);
    followCooling(step);
}

/// Gas flows with the trigger and for a while after the arc, so that the hot metal does not burn.
void SoundState::followGas(const SoundStep& step) {
    const bool shielded = step.process == SoundProcess::gmaw || step.process == SoundProcess::gtaw;
    if (arc_)
        postFlow_ = step.process == SoundProcess::gmaw
                        ? kGmawPostFlow
                        : std::max(kGtawPostFlow, kGtawPostFlowPerAmpere * static_cast<double>(step.arc.current));
    const bool flows = shielded && (step.trigger >= kPulled || postFlow_ > 0);
    levels_.gas = flows ? 0.008F : 0;
    if (!arc_) postFlow_ = shielded ? std::max(postFlow_ - step.seconds, 0.0) : 0;
}

void SoundState::followCooling(const SoundStep& step) {
    ticks_ = 0;
    const bool cools = !arc_ && step.process != SoundProcess::none && step.hottest > 0 && step.hottest < kTickBelow;
    if (!cools || lastTick_ <= 0 || step.hottest > lastTick_) {
        lastTick_ = cools ? step.hottest : 0;
        return;
    }
    if (lastTick_ - step.hottest < kTickStep) return;
    ticks_ = 1; // one a step: two at once would be heard as one
    lastTick_ -= kTickStep;
}

} // namespace meltpool
