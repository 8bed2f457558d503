#include "core/training/feedback/sound/sound_state.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr float kPulled = 0.05F;       // least value of a pulled trigger
constexpr float kScratchSpeed = 0.05F; // m/s of the loudest scratch
constexpr float kTouches = 0.3e-3F;    // m

void hearArc(const SoundStep& step, SoundLevels& levels) {
    const ArcState& arc = step.arc;
    const ProcessSound& sound = step.process->sound;
    const float strength = std::clamp(arc.share, 0.0F, 1.0F);
    const bool open = arc.action == ArcAction::burning || arc.action == ArcAction::breaking;
    if (open) {
        levels.hiss = strength * (sound.quiet + (sound.loud - sound.quiet) * arc.stretch);
        levels.hissPitch = sound.lowPitch + (sound.highPitch - sound.lowPitch) * arc.stretch;
    }
    if (arc.action == ArcAction::shorting) { // share of the noise between two short circuits
        levels.hiss = 0.5F * sound.quiet;
        levels.hissPitch = sound.lowPitch;
    }
    if (step.process->feedsWire && open) {
        levels.drops = 0.07F * strength;
        levels.dropRate = step.dropRate;
    }
    if (sound.crackles) {
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

/// Loudness of an electrode's end that scratches over the metal without an arc.
float scratchOf(const SoundStep& step) {
    if (!step.process->sound.scratches || step.arc.burns() || step.trigger < kPulled || step.arc.distance > kTouches)
        return 0;
    return 0.06F * std::clamp(step.tipSpeed / kScratchSpeed, 0.0F, 1.0F);
}

} // namespace

bool SoundLevels::silent() const {
    return hiss + drops + crackle + buzz + roar + gas + stub + scratch <= 0;
}

void SoundState::step(const SoundStep& step) {
    if (step.process == nullptr) {
        *this = {};
        return;
    }
    levels_ = {};
    strike_ = 0;
    const bool burned = arc_;
    arc_ = step.process->arc && step.arc.burns();
    if (arc_) hearArc(step, levels_);
    if (arc_ && !burned) strike_ = std::clamp(step.arc.voltage * step.arc.current, 0.1F * kFullArcPower, kFullArcPower);
    if (step.trigger >= kPulled) levels_.roar = step.process->sound.roar * step.trigger;
    levels_.scratch = scratchOf(step);
    followGas(step);
    followCooling(step);
}

/// Gas flows with the trigger and for a while after the arc, so that the hot metal does not burn.
void SoundState::followGas(const SoundStep& step) {
    const bool shielded = step.process->shielding == Shielding::gas && !step.withoutGas;
    const ProcessSound& sound = step.process->sound;
    if (arc_) postFlow_ = std::max(sound.postFlow, sound.postFlowPerAmpere * static_cast<double>(step.arc.current));
    const bool flows = shielded && (step.trigger >= kPulled || postFlow_ > 0);
    levels_.gas = flows ? 0.008F : 0;
    if (!arc_) postFlow_ = shielded ? std::max(postFlow_ - step.seconds, 0.0) : 0;
}

void SoundState::followCooling(const SoundStep& step) {
    ticks_ = 0;
    const bool cools = !arc_ && step.hottest > 0 && step.hottest < kTickBelow;
    if (!cools || lastTick_ <= 0 || step.hottest > lastTick_) {
        lastTick_ = cools ? step.hottest : 0;
        return;
    }
    if (lastTick_ - step.hottest < kTickStep) return;
    ticks_ = 1; // one tick a step: two at once sound like one
    lastTick_ -= kTickStep;
}

} // namespace meltpool
