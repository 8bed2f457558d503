#include "core/training/feedback/sound/sound_voices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRate = kSoundRate;
constexpr float kWhite = 0.57735F;    // root mean square of even noise from -1 to 1
constexpr float kTiny = 1e-9F;        // inaudible below this, and processors are slow with far smaller numbers
constexpr double kHighestBand = 9000; // Hz
constexpr int kOvertones = 6;
constexpr float kHumScale = 1.16F; // scales kOvertones to root mean square 1: sqrt(2 / (1 + 1/4 + ... + 1/36))
constexpr double kPopDecay = 0.9e-3;

} // namespace

float NoiseSource::next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return static_cast<float>(static_cast<double>(state_) * 0x1p-31 - 1);
}

void Ramp::to(float level, size_t samples) {
    end_ = level;
    slope_ = samples > 0 ? (end_ - now_) / static_cast<float>(samples) : 0;
    if (samples == 0) now_ = end_;
}

float Ramp::next() {
    const float before = now_;
    now_ += slope_;
    const bool there = slope_ == 0 || (slope_ > 0 ? now_ >= end_ : now_ <= end_);
    if (there) {
        now_ = end_;
        slope_ = 0;
    }
    return before;
}

void NoiseBand::set(float level, float pitch, float quality, size_t samples) {
    level_.to(level, samples);
    if (pitch <= 0 || (pitch == pitch_ && quality == quality_)) return;
    pitch_ = pitch;
    quality_ = quality;
    const double middle = std::min(static_cast<double>(pitch), kHighestBand);
    const double g = std::tan(std::numbers::pi * middle / kRate);
    const double k = 1 / static_cast<double>(quality);
    g_ = static_cast<float>(g);
    k_ = static_cast<float>(k);
    a1_ = static_cast<float>(1 / (1 + g * (g + k)));
    a2_ = static_cast<float>(g / (1 + g * (g + k)));
    // The band lets through as much as a rectangle of pi/2 times its width.
    const double passes = std::min(std::numbers::pi / 2 * middle * k / (kRate / 2), 1.0);
    scale_ = static_cast<float>(1 / (static_cast<double>(kWhite) * std::sqrt(passes)));
}

float NoiseBand::next(float noise) {
    const float level = level_.next();
    const float high = noise - second_;
    const float band = a1_ * first_ + a2_ * high;
    const float low = second_ + g_ * band;
    first_ = 2 * band - first_;
    second_ = 2 * low - second_;
    return level * scale_ * k_ * band;
}

void HumVoice::set(float level, float pitch, size_t samples) {
    level_.to(level, samples);
    if (pitch > 0) advance_ = static_cast<double>(pitch) / kRate;
}

float HumVoice::next() {
    const float level = level_.next();
    phase_ += advance_;
    phase_ -= std::floor(phase_);
    if (level <= kTiny) return 0;
    // The sine of n x follows from the two before it.
    const double sine = std::sin(kTurn * phase_), twice = 2 * std::cos(kTurn * phase_);
    double before = 0, tone = sine, sum = 0;
    for (int n = 1; n <= kOvertones; ++n) {
        sum += tone / n;
        const double after = twice * tone - before;
        before = tone;
        tone = after;
    }
    return level * kHumScale * static_cast<float>(sum);
}

void PopVoice::set(float level, float rate, size_t samples) {
    level_.to(level, samples);
    if (rate <= 0) {
        chance_ = 0;
        return;
    }
    chance_ = static_cast<float>(static_cast<double>(rate) / kRate);
    // A burst a exp(-t / decay) carries a² decay / 2 of the noise's power, and a² is 1/3 on average.
    const double power = static_cast<double>(rate) * kPopDecay / 2 / 3;
    scale_ = static_cast<float>(1 / std::sqrt(power));
}

float PopVoice::next(NoiseSource& chance, float noise) {
    static const float kFade = static_cast<float>(std::exp(-1 / (kPopDecay * kRate)));
    const float level = level_.next();
    if (chance.share() < chance_) burst_ = std::max(burst_, chance.share());
    burst_ = burst_ > kTiny ? burst_ * kFade : 0;
    return level * scale_ * burst_ * noise;
}

Ringing::Ringing(double pitch, double decay)
    : turnCosine_(static_cast<float>(std::exp(-1 / (decay * kRate)) * std::cos(kTurn * pitch / kRate))),
      turnSine_(static_cast<float>(std::exp(-1 / (decay * kRate)) * std::sin(kTurn * pitch / kRate))) {}

float Ringing::next() {
    const float heard = cosine_;
    const float turned = cosine_ * turnCosine_ - sine_ * turnSine_;
    sine_ = sine_ * turnCosine_ + cosine_ * turnSine_;
    cosine_ = turned;
    if (std::abs(cosine_) + std::abs(sine_) < kTiny) cosine_ = sine_ = 0;
    return heard;
}

float limited(float sum) {
    constexpr float kStraight = 0.7F, kRoom = 0.28F;
    const float size = std::abs(sum);
    if (size <= kStraight) return sum;
    return std::copysign(kStraight + kRoom * std::tanh((size - kStraight) / kRoom), sum);
}

} // namespace meltpool
