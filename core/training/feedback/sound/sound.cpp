#include "core/training/feedback/sound/sound.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kClick = 0.6F;  // amplitude of a jump of kFullArcPower
constexpr float kStrike = 0.5F; // amplitude of a strike
constexpr float kTick = 0.06F;
constexpr float kChip = 0.16F;
constexpr float kStubPitch = 45; // Hz
constexpr size_t kBetweenChips = Sound::kRate * 7 / 20;

} // namespace

void Sound::begin(const SoundStep& step) {
    state_.step(step);
    owed_ += std::max(step.seconds, 0.0) * kRate;
    left_ = static_cast<size_t>(owed_);
    owed_ -= static_cast<double>(left_);
    done_ = 0;
    nextShort_ = 0;
    shortCount_ = std::min(step.shortCount, step.shorts.size());
    shorts_ = step.shorts;
    chips_ += step.chips;
    const SoundLevels& levels = state_.levels();
    hiss_.set(levels.hiss, levels.hissPitch, 0.9F, left_);
    gas_.set(levels.gas, 4200, 0.7F, left_);
    roar_.set(levels.roar, 330, 0.6F, left_);
    scratch_.set(levels.scratch, 3100, 1.5F, left_);
    stubNoise_.set(0.6F * levels.stub, 900, 0.8F, left_);
    drops_.set(levels.drops, levels.dropRate, left_);
    buzz_.set(levels.buzz, levels.buzzRate, left_);
    stub_.set(0.8F * levels.stub, kStubPitch, left_);
    popNoise_.set(1, levels.cracklePitch, 0.7F, left_);
    crackle_.set(levels.crackle, levels.crackleRate, left_);
    if (state_.strike() > 0) strike_.strike(kStrike * state_.strike() / kFullArcPower);
    if (state_.ticks() > 0) tick_.strike(kTick * (0.5F + 0.5F * noise_.share()));
}

void Sound::beginEvents(size_t sample) {
    const auto now = static_cast<float>(sample + 1) / kRate;
    // A short circuit at the very end of a step begins with the last sample.
    const bool last = left_ == 1;
    for (; nextShort_ < shortCount_ && (shorts_[nextShort_].at < now || last); ++nextShort_)
        click_.strike(kClick * std::clamp(shorts_[nextShort_].power / kFullArcPower, 0.0F, 1.0F));
    if (untilChip_ > 0) --untilChip_;
    if (chips_ == 0 || untilChip_ > 0) return;
    --chips_;
    untilChip_ = kBetweenChips;
    for (Ringing& tone : chip_)
        tone.strike(kChip);
}

float Sound::mix() {
    const float noise = noise_.next();
    float sum = hiss_.next(noise) + gas_.next(noise) + roar_.next(noise);
    sum += scratch_.next(noise_.next());
    sum += drops_.next() + buzz_.next();
    sum += stub_.next() + stubNoise_.next(noise) * (stub_.phase() < 0.3 ? 1.0F : 0.3F);
    sum += crackle_.next(noise_, popNoise_.next(noise));
    sum += click_.next() + strike_.next() + tick_.next();
    for (Ringing& tone : chip_)
        sum += tone.next();
    return limited(sum);
}

size_t Sound::read(std::span<float> out) {
    const size_t count = std::min(left_, out.size());
    for (size_t i = 0; i < count; ++i) {
        beginEvents(done_++);
        out[i] = mix();
        --left_;
    }
    return count;
}

} // namespace meltpool
