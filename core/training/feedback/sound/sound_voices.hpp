// Makes the parts of the sound: noise, bands of noise, hums, pops, and the ringing after a blow.
#pragma once

#include <cstddef>
#include <cstdint>

namespace meltpool {

inline constexpr int kSoundRate = 48000; ///< samples a second

/// White noise from a shift register (Marsaglia 2003, xorshift32).
class NoiseSource {
  public:
    /// Next sample, -1..1, evenly distributed; its root mean square is 0.577.
    float next();
    /// Next number, 0..1.
    float share() { return 0.5F * (next() + 1); }

  private:
    std::uint32_t state_ = 0x9D2C5680U;
};

/// A level that moves to each new value within the step, so that a change does not click.
class Ramp {
  public:
    /// Reaches `level` after `samples`.
    void to(float level, size_t samples);
    float next();

  private:
    float now_ = 0, end_ = 0, slope_ = 0;
};

/// A band of noise: a state-variable filter (Zavalishin, "The Art of VA Filter Design", 2012, chapter 4) behind a
/// NoiseSource.
class NoiseBand {
  public:
    /// `level`: root mean square of the output; `pitch`: Hz, centre of the band; `quality`: pitch over its width.
    void set(float level, float pitch, float quality, size_t samples);
    float next(float noise);

  private:
    Ramp level_;
    float pitch_ = 0, quality_ = 0;
    float a1_ = 0, a2_ = 0, g_ = 0, k_ = 0, scale_ = 0;
    float first_ = 0, second_ = 0;
};

/// A tone with overtones 1/n.
class HumVoice {
  public:
    /// `level`: root mean square; `pitch`: Hz, 0 leaves it unchanged.
    void set(float level, float pitch, size_t samples);
    float next();
    /// Phase of the tone's period, 0..1.
    double phase() const { return phase_; }

  private:
    Ramp level_;
    double phase_ = 0, advance_ = 0;
};

/// Short bursts at random times, of random loudness.
class PopVoice {
  public:
    /// `level`: root mean square; `rate`: 1/s.
    void set(float level, float rate, size_t samples);
    /// `noise`: source of the bursts, root mean square 1.
    float next(NoiseSource& chance, float noise);

  private:
    Ramp level_;
    float chance_ = 0, scale_ = 0, burst_ = 0;
};

/// A tone that dies away after each blow.
class Ringing {
  public:
    /// `pitch`: Hz; `decay`: s until 1/e of it is left.
    Ringing(double pitch, double decay);
    void strike(float amplitude) { cosine_ += amplitude; }
    float next();

  private:
    float turnCosine_, turnSine_;
    float cosine_ = 0, sine_ = 0;
};

/// Limits a sum to -1..1: linear up to 0.7, then ever flatter; never reaches 0.99.
float limited(float sum);

} // namespace meltpool
