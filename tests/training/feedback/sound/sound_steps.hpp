// Synthetic arc steps for the tests of the sound.
#pragma once

#include "core/training/feedback/sound/sound.hpp"

#include <cmath>
#include <vector>

namespace meltpool::test {

inline constexpr double kSoundStep = 1.0 / 90; ///< duration of a step, s

/// Returns an open arc of 120 A; `stretch` 0..1.
inline SoundStep openArc(const ProcessTraits& process, float stretch = 0, float share = 1) {
    SoundStep step;
    step.seconds = kSoundStep;
    step.process = &process;
    step.trigger = share;
    step.arc.action = ArcAction::burning;
    step.arc.share = share;
    step.arc.stretch = stretch;
    step.arc.length = 2e-3F + 4e-3F * stretch;
    step.arc.voltage = 20;
    step.arc.current = 120;
    return step;
}

inline SoundStep noArc(const ProcessTraits& process, float trigger = 0) {
    SoundStep step;
    step.seconds = kSoundStep;
    step.process = &process;
    step.trigger = trigger;
    step.arc.noArc = NoArc::released;
    return step;
}

/// Returns a wire that shorts `rate` times a second; takes the short circuits of the step from `shorts`.
inline SoundStep shorting(ShortCircuits& shorts, float rate = 120) {
    SoundStep step = openArc(Gmaw::kTraits);
    step.arc.action = ArcAction::shorting;
    step.arc.length = 0;
    step.arc.shorts = rate;
    shorts.step(step.arc, step.seconds);
    step.shortCount = shorts.last().size();
    std::copy(shorts.last().begin(), shorts.last().end(), step.shorts.begin());
    step.shortPhase = shorts.phase();
    return step;
}

/// Adds the sound of the step.
inline void append(std::vector<float>& samples, Sound& sound, const SoundStep& step) {
    sound.begin(step);
    const size_t before = samples.size();
    samples.resize(before + sound.left());
    sound.read(std::span(samples).subspan(before));
}

/// Returns the sound of `seconds` of equal steps.
inline std::vector<float> soundOf(const SoundStep& step, double seconds) {
    Sound sound;
    std::vector<float> samples;
    for (double time = 0; time < seconds; time += step.seconds)
        append(samples, sound, step);
    return samples;
}

inline double rootMeanSquare(std::span<const float> samples) {
    double sum = 0;
    for (const float sample : samples)
        sum += static_cast<double>(sample) * static_cast<double>(sample);
    return samples.empty() ? 0 : std::sqrt(sum / static_cast<double>(samples.size()));
}

/// Returns the root mean square frequency by the sound's power, Hz.
inline double meanFrequency(std::span<const float> samples) {
    double power = 0, slope = 0;
    for (size_t i = 1; i < samples.size(); ++i) {
        const double now = static_cast<double>(samples[i]), step = now - static_cast<double>(samples[i - 1]);
        power += now * now;
        slope += step * step;
    }
    return power > 0 ? std::sqrt(slope / power) * Sound::kRate / (2 * 3.14159265358979) : 0;
}

} // namespace meltpool::test
