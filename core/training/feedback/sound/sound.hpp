// Synthesises the sound of a lesson's steps sample by sample from the state of the arc, without recordings.
#pragma once

#include "core/training/feedback/sound/sound_state.hpp"
#include "core/training/feedback/sound/sound_voices.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace meltpool {

/// Synthesises one channel. Equal steps give equal samples, to the last bit. Allocates nothing.
class Sound {
  public:
    static constexpr int kRate = kSoundRate;

    /// Starts a step; read() then gives its samples. Drops unread samples of the step before.
    void begin(const SoundStep& step);
    /// Unread samples of the step.
    size_t left() const { return left_; }
    /// Reads the next samples of the step, -1..1, without reaching either end: as many as `out` holds or are left.
    /// Returns their number.
    size_t read(std::span<float> out);

    /// State of the present sound.
    const SoundState& state() const { return state_; }

  private:
    void beginEvents(size_t sample);
    float mix();

    SoundState state_;
    std::array<ShortCircuit, ShortCircuits::kMost> shorts_{};
    size_t shortCount_ = 0;
    size_t nextShort_ = 0;
    int chips_ = 0;
    double owed_ = 0; ///< samples that the steps so far lasted beyond the samples given
    size_t left_ = 0;
    size_t done_ = 0;
    size_t untilChip_ = 0; ///< samples
    NoiseSource noise_;
    NoiseBand hiss_, gas_, roar_, scratch_, stubNoise_, popNoise_;
    HumVoice drops_, buzz_, stub_;
    PopVoice crackle_;
    Ringing click_{1800, 0.9e-3}, strike_{420, 5e-3}, tick_{4300, 5e-3};
    std::array<Ringing, 3> chip_{Ringing{2310, 25e-3}, Ringing{3870, 15e-3}, Ringing{5630, 10e-3}};
};

} // namespace meltpool
